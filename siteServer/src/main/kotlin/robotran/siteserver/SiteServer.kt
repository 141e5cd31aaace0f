package robotran.siteserver

import com.sun.net.httpserver.HttpExchange
import com.sun.net.httpserver.HttpServer
import java.net.BindException
import java.net.InetAddress
import java.net.InetSocketAddress
import java.net.ServerSocket
import java.nio.file.Files
import java.nio.file.InvalidPathException
import java.nio.file.Path
import java.util.concurrent.ExecutorService
import java.util.concurrent.Executors
import kotlin.io.path.extension
import kotlin.io.path.isRegularFile

/**
 * Serves the built site on localhost only, with the headers listed in docs/hosting.md. A client that sends only half of
 * a request, or does not take the answer, keeps nobody else waiting and is dropped after a while.
 *
 * @param folder the output of `./gradlew :webApp:dist`.
 */
class SiteServer private constructor(
    private val folder: Path,
    private val server: HttpServer,
    private val threads: ExecutorService,
) : AutoCloseable {
    /** The URL to open in a browser. */
    val address: String get() = "http://$host/"

    /** What links to the site begin with, without the scheme. */
    val host: String = "localhost:${server.address.port}"

    init {
        server.executor = threads
        server.createContext("/") { exchange -> exchange.use(::answer) }
        server.start()
    }

    private fun answer(exchange: HttpExchange) {
        val isHead = exchange.requestMethod == "HEAD"
        val file = fileFor(exchange.requestURI.path.orEmpty())
        exchange.responseHeaders["X-Content-Type-Options"] = "nosniff"
        when {
            !isHead && exchange.requestMethod != "GET" -> {
                exchange.responseHeaders["Allow"] = "GET, HEAD"
                exchange.sendResponseHeaders(METHOD_NOT_ALLOWED, NO_BODY)
            }

            file == null -> exchange.sendResponseHeaders(NOT_FOUND, NO_BODY)

            else -> {
                exchange.responseHeaders["Content-Type"] = TYPES[file.extension] ?: "application/octet-stream"
                exchange.responseHeaders["Cache-Control"] =
                    if (file.startsWith(folder.resolve(FILES))) NEVER_CHANGES else ASK_EACH_TIME
                val bytes = Files.readAllBytes(file)
                exchange.sendResponseHeaders(OK, if (isHead) NO_BODY else bytes.size.toLong())
                if (!isHead) exchange.responseBody.write(bytes)
            }
        }
    }

    /** Returns only files inside the folder. */
    private fun fileFor(path: String): Path? {
        val file =
            try {
                folder.resolve(path.trimStart('/').ifEmpty { PAGE }).normalize()
            } catch (_: InvalidPathException) {
                return null
            }
        return file.takeIf { it.startsWith(folder) && it.isRegularFile() }
    }

    override fun close() {
        server.stop(0)
        threads.shutdownNow()
    }

    companion object {
        private const val PAGE = "index.html"
        private const val FILES = "files"
        private const val NEVER_CHANGES = "public, max-age=31536000, immutable"
        private const val ASK_EACH_TIME = "no-cache"
        private const val OK = 200
        private const val NOT_FOUND = 404
        private const val METHOD_NOT_ALLOWED = 405
        private const val NO_BODY = -1L

        /** Seconds, and a number of connections. The JDK's server takes them as properties, and has no limit without. */
        private val LIMITS =
            mapOf(
                "sun.net.httpserver.maxReqTime" to "10",
                "sun.net.httpserver.maxRspTime" to "300",
                "jdk.httpserver.maxConnections" to "500",
            )
        private val TYPES =
            mapOf(
                "html" to "text/html; charset=utf-8",
                "js" to "text/javascript",
                "wasm" to "application/wasm",
                "webmanifest" to "application/manifest+json",
                "svg" to "image/svg+xml",
                "png" to "image/png",
                "ttf" to "font/ttf",
                "txt" to "text/plain; charset=utf-8",
            )

        /** Whether [folder] contains a built site. */
        fun hasSite(folder: Path): Boolean = folder.resolve(PAGE).isRegularFile()

        /** Whether [port] can be used now. */
        fun isFree(port: Int): Boolean = try {
            ServerSocket(port, 1, InetAddress.getLoopbackAddress()).close()
            true
        } catch (_: BindException) {
            false
        }

        /**
         * Starts to serve [folder]; null if the port is not available.
         *
         * @param port 0 for any free port.
         */
        fun start(folder: Path, port: Int): SiteServer? {
            LIMITS.forEach { (name, limit) -> if (System.getProperty(name) == null) System.setProperty(name, limit) }
            val server =
                try {
                    HttpServer.create(InetSocketAddress(InetAddress.getLoopbackAddress(), port), 0)
                } catch (_: BindException) {
                    return null
                }
            // As many as there are connections: each keeps one while its request arrives.
            val threads = Executors.newCachedThreadPool { work -> Thread(work).apply { isDaemon = true } }
            return SiteServer(folder.toAbsolutePath().normalize(), server, threads)
        }
    }
}
