#!/bin/sed -Ef
# Citations of headings in comments (docs/ray-rule.md#tolerances) as links of the Doxygen pages. The labels are those that
# cmake/page-filter gives the headings. READMEs of rooms are no pages: the heading is named in words.
s,docs/([A-Za-z0-9_-]+)\.md#([A-Za-z0-9_-]+),[docs/\1.md](#page-docs-\1-\2),g
s,docs/([a-z]+)/([A-Za-z0-9_-]+)\.md#([A-Za-z0-9_-]+),[docs/\1/\2.md](#page-docs-\1-\2-\3),g
s,((src|worlds|shaders)[A-Za-z/]*/README\.md)#([A-Za-z0-9_-]+),\1 (\3),g
