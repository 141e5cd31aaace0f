package robotran.siteserver

import java.net.InetAddress
import java.net.ServerSocket
import java.net.Socket
import java.net.URI
import java.net.http.HttpClient
import java.net.http.HttpRequest
import java.net.http.HttpResponse
import java.nio.file.Files
import java.nio.file.Path
import kotlin.io.path.createDirectories
import kotlin.io.path.createParentDirectories
import kotlin.io.path.writeText
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertEquals
import kotlin.test.assertNotNull
import kotlin.test.assertNull

class SiteServerTest {
    private val folder: Path = Files.createTempDirectory("robotran-site")
    private val site = folder.resolve("site").createDirectories()
    private val client = HttpClient.newHttpClient()

    init {
        write("site/index.html", "<p>the page</p>")
        write("site/files/robotran.0123456789abcdef.wasm", "wasm")
        write("site/manifest.webmanifest", "{}")
        write("secret.txt", "not for the world")
    }

    @AfterTest
    fun tidyUp() {
        folder.toFile().deleteRecursively()
    }

    private fun write(path: String, text: String) = folder.resolve(path).createParentDirectories().writeText(text)

    private fun ask(server: SiteServer, path: String, method: String = "GET"): HttpResponse<String> {
        val request = HttpRequest.newBuilder(
            URI(server.address.dropLast(1) + path),
        ).method(method, HttpRequest.BodyPublishers.noBody())
        return client.send(request.build(), HttpResponse.BodyHandlers.ofString())
    }

    private fun <T> serving(action: (SiteServer) -> T): T = assertNotNull(SiteServer.start(site, 0)).use(action)

    private fun HttpResponse<String>.header(name: String) = headers().firstValue(name).orElse(null)

    @Test
    fun `the page is asked for anew each time and other files never again`() = serving { server ->
        val page = ask(server, "/")
        assertEquals("<p>the page</p>", page.body())
        assertEquals("text/html; charset=utf-8", page.header("content-type"))
        assertEquals("no-cache", page.header("cache-control"))
        val module = ask(server, "/files/robotran.0123456789abcdef.wasm")
        assertEquals("wasm", module.body())
        assertEquals("application/wasm", module.header("content-type"))
        assertEquals("public, max-age=31536000, immutable", module.header("cache-control"))
        assertEquals("nosniff", module.header("x-content-type-options"))
        assertEquals("application/manifest+json", ask(server, "/manifest.webmanifest").header("content-type"))
    }

    @Test
    fun `what is not there, or lies outside of the folder, is not found`() = serving { server ->
        val outside = listOf("/../secret.txt", "/%2e%2e/secret.txt", "/files/..%2f..%2fsecret.txt", "//secret.txt")
        for (path in listOf(
            "/nothing.js",
            "/files",
            "/files/",
            "/%00",
        ) + outside) {
            assertEquals(404, ask(server, path).statusCode(), path)
        }
    }

    @Test
    fun `it can be looked at and not written to`() = serving { server ->
        assertEquals("", ask(server, "/", "HEAD").body())
        assertEquals(200, ask(server, "/", "HEAD").statusCode())
        assertEquals(405, ask(server, "/", "PUT").statusCode())
        assertEquals("GET, HEAD", ask(server, "/", "DELETE").header("allow"))
    }

    @Test
    fun `half a request keeps nobody waiting and is dropped`() = serving { server ->
        val port = URI(server.address).port
        val halves = List(MANY) { number ->
            Socket(InetAddress.getLoopbackAddress(), port).apply {
                val head = if (number % 2 == 0) {
                    "GET / HT"
                } else {
                    "POST / HTTP/1.1\r\nHost: a\r\nContent-Length: 9\r\n\r\n1"
                }
                getOutputStream().write(head.encodeToByteArray())
                getOutputStream().flush()
            }
        }
        try {
            assertEquals("<p>the page</p>", ask(server, "/").body())
            assertEquals(-1, halves.first().getInputStream().read(), "The server has closed it.")
        } finally {
            halves.forEach(Socket::close)
        }
    }

    @Test
    fun `a port that somebody else has cannot be had`() {
        ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use { assertNull(SiteServer.start(site, it.localPort)) }
    }

    private companion object {
        const val MANY = 40
    }
}
