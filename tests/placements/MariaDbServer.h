#pragma once

#include "support/TemporaryDirectory.h"

#include <chrono>
#include <csignal>
#include <mysql.h>
#include <sys/wait.h>
#include <thread>
#include <unistd.h>

namespace limen::test {

/// A MariaDB server with data of its own in a temporary directory. It listens on a socket there, and on no port. It ends
/// with the object.
class MariaDbServer {
public:
    MariaDbServer() {
        const std::string data = (directory_ / "data").string();
        const std::string install =
            "PATH=$PATH:/usr/sbin mariadb-install-db --no-defaults --auth-root-authentication-method="
            "normal --skip-test-db --datadir='" +
            data + "' " + userOption() + " >'" + (directory_ / "install.log").string() + "' 2>&1";
        if (std::system(install.c_str()) != 0) {
            ADD_FAILURE() << "mariadb-install-db failed: " << getText(directory_ / "install.log");
            return;
        }
        start(data);
        for (int i = 0; i < 300 && !isReady_; ++i) {
            std::this_thread::sleep_for(std::chrono::milliseconds(100));
            isReady_ = run("SELECT 1").empty();
        }
        if (!isReady_)
            ADD_FAILURE() << "the server does not answer: " << getText(directory_ / "server.log");
    }
    ~MariaDbServer() {
        if (process_ <= 0)
            return;
        kill(process_, SIGTERM);
        int status = 0;
        for (int i = 0; i < 200; ++i) {
            if (waitpid(process_, &status, WNOHANG) == process_)
                return;
            std::this_thread::sleep_for(std::chrono::milliseconds(50));
        }
        kill(process_, SIGKILL);
        waitpid(process_, &status, 0);
    }
    MariaDbServer(const MariaDbServer&) = delete;
    MariaDbServer& operator=(const MariaDbServer&) = delete;

    [[nodiscard]] bool isReady() const { return isReady_; }
    [[nodiscard]] std::string socket() const { return (directory_ / "s").string(); }

    /// Executes statements as the user root. Returns the error, or "".
    [[nodiscard]] std::string run(const std::string& statements, const std::string& database = "") const {
        MYSQL* connection = mysql_init(nullptr);
        mysql_options(connection, MYSQL_SET_CHARSET_NAME, "utf8mb4");
        std::string error;
        if (mysql_real_connect(connection, nullptr, "root", nullptr,
                               database.empty() ? nullptr : database.c_str(), 0, socket().c_str(),
                               CLIENT_MULTI_STATEMENTS) == nullptr ||
            mysql_real_query(connection, statements.data(), statements.size()) != 0)
            error = mysql_error(connection);
        else
            error = drain(connection);
        mysql_close(connection);
        return error;
    }

private:
    static std::string userOption() { return geteuid() == 0 ? "--user=root" : ""; }

    static std::string drain(MYSQL* connection) {
        for (;;) {
            if (MYSQL_RES* result = mysql_store_result(connection))
                mysql_free_result(result);
            const int status = mysql_next_result(connection);
            if (status != 0)
                return status > 0 ? mysql_error(connection) : "";
        }
    }

    void start(const std::string& data) {
        process_ = fork();
        if (process_ != 0)
            return;
        const std::string log = (directory_ / "server.log").string();
        if (std::freopen(log.c_str(), "w", stderr) == nullptr ||
            std::freopen(log.c_str(), "a", stdout) == nullptr)
            _exit(126);
        const std::string dataOption = "--datadir=" + data, socketOption = "--socket=" + socket(),
                          pidOption = "--pid-file=" + (directory_ / "pid").string(), user = userOption();
        for (const char* program : {"/usr/sbin/mariadbd", "mariadbd"})
            execlp(program, program, "--no-defaults", dataOption.c_str(), socketOption.c_str(),
                   pidOption.c_str(), "--skip-networking", "--innodb-buffer-pool-size=32M",
                   "--innodb-flush-log-at-trx-commit=0", user.empty() ? nullptr : user.c_str(), nullptr);
        _exit(127);
    }

    TemporaryDirectory directory_;
    pid_t process_ = -1;
    bool isReady_ = false;
};

} // namespace limen::test
