package robotran.siteserver

import com.github.ajalt.clikt.core.CoreNoOpCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.core.parse
import com.github.ajalt.clikt.core.subcommands
import robotran.console.RecordingConsole
import robotran.console.carryOut
import java.net.InetAddress
import java.net.ServerSocket
import java.net.URI
import java.nio.file.Files
import kotlin.io.path.createDirectories
import kotlin.io.path.writeText
import kotlin.test.AfterTest
import kotlin.test.Test
import kotlin.test.assertContains
import kotlin.test.assertEquals
import kotlin.test.assertFailsWith

class WebCommandTest {
    private val console = RecordingConsole()
    private val folder = Files.createTempDirectory("robotran-web")
    private val site: String
        get() {
            val site = folder.resolve("site").createDirectories()
            site.resolve("index.html").writeText("<p>the page</p>")
            return site.toString()
        }

    @AfterTest
    fun tidyUp() {
        folder.toFile().deleteRecursively()
    }

    private fun web(vararg arguments: String) = console.carryOut(listOf("web") + arguments) {
        CoreNoOpCliktCommand("robotran").subcommands(WebCommand(console))
    }

    @Test
    fun `the site is served at the address that is told`() {
        var page = ""
        WebCommand(console) { page = URI(it.address).toURL().readText() }.parse(listOf("--port", "0", "--site", site))
        assertEquals("<p>the page</p>", page)
        assertContains(console.said.first(), Regex("http://localhost:\\d+/ for this machine alone"))
        assertContains(console.said.last(), Regex("begin with localhost:\\d+ work on this machine only"))
    }

    @Test
    fun `a folder without a site is refused with how to make one`() {
        assertEquals(2, web("--site", folder.toString()))
        assertEquals(listOf("There is no built site in $folder. ./gradlew :webApp:dist makes it."), console.complaints)
    }

    @Test
    fun `a packed Robotran says that it has no site`() {
        assertEquals(2, web())
        assertContains(console.complaints.single(), "has no web site with it")
    }

    @Test
    fun `a port that is taken is told`() {
        ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use {
            val result = assertFailsWith<ProgramResult> {
                WebCommand(console) {
                    error("It is not served.")
                }.parse(listOf("--port", "${it.localPort}", "--site", site))
            }
            assertEquals(2, result.statusCode)
            assertContains(console.complaints.single(), "Port ${it.localPort} cannot be used")
        }
    }

    @Test
    fun `the arguments can be looked at before there is a site`() {
        System.setProperty("robotran.only-asked", "true")
        try {
            assertEquals(0, web("--port", "0"))
            assertEquals(emptyList(), console.said + console.complaints)
            assertEquals(2, web("--port", "70000"))
            ServerSocket(0, 1, InetAddress.getLoopbackAddress()).use {
                assertEquals(2, web("--port", "${it.localPort}"))
            }
        } finally {
            System.clearProperty("robotran.only-asked")
        }
    }

    @Test
    fun `what is asked for in another language is told in it`() {
        assertEquals(2, web("--language", "fr"))
        assertContains(console.complaints.single(), "n'a pas de site web")
    }

    @Test
    fun `a port that is none is refused`() {
        assertEquals(2, web("--port", "70000"))
        assertContains(console.complaints.single(), "70000")
    }
}
