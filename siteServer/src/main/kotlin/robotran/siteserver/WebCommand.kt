package robotran.siteserver

import com.github.ajalt.clikt.core.Context
import com.github.ajalt.clikt.core.CoreCliktCommand
import com.github.ajalt.clikt.core.ProgramResult
import com.github.ajalt.clikt.parameters.groups.provideDelegate
import com.github.ajalt.clikt.parameters.options.default
import com.github.ajalt.clikt.parameters.options.option
import com.github.ajalt.clikt.parameters.types.int
import com.github.ajalt.clikt.parameters.types.restrictTo
import robotran.console.Console
import robotran.console.ExitCode
import robotran.console.LanguageOption
import robotran.console.messages.ConsoleMessages
import robotran.console.speaking
import kotlin.io.path.Path

/**
 * `robotran web`: serves the built site to browsers on this machine.
 *
 * @param stay blocks until the server should stop.
 */
class WebCommand(
    private val process: Console,
    private val stay: (SiteServer) -> Unit = { Thread.sleep(Long.MAX_VALUE) },
) : CoreCliktCommand("web") {
    private val port by option(
        "--port",
        metavar = "N",
        help = "the port, $DEFAULT_PORT if not given; 0 for any that is free",
    )
        .int().restrictTo(0..HIGHEST_PORT).default(DEFAULT_PORT)
    private val site by option(
        "--site",
        metavar = "FOLDER",
        help = "the site to serve, as ./gradlew :webApp:dist makes it; that of this source tree if not given",
    )

    private val spoken by LanguageOption()
    private val console get() = process.speaking(spoken.language)
    private val aboutSite get() = ConsoleMessages.of(spoken.language)

    override fun help(context: Context) = "Serves the web site of Robotran to browsers on this machine."

    override fun run() {
        if (!SiteServer.isFree(port)) refuse(aboutSite.portTaken(port))
        if (isOnlyAsked()) return
        val folder = (site ?: System.getProperty(SITE))?.let { Path(it) } ?: refuse(aboutSite.siteNotHere())
        if (!SiteServer.hasSite(folder)) refuse(aboutSite.siteNotBuilt(folder.toString()))
        val server = SiteServer.start(folder, port) ?: refuse(aboutSite.portTaken(port))
        server.use {
            console.say(aboutSite.siteServed(it.address))
            console.say(aboutSite.linksStayHere(it.host))
            stay(it)
        }
    }

    private fun refuse(words: String): Nothing {
        console.complain(words)
        throw ProgramResult(ExitCode.BAD_INPUT.status)
    }

    companion object {
        /** The system property that `./robotran` sets to the folder of the built site. */
        const val SITE = "robotran.site"

        /** The system property by which `./robotran` asks only whether a command can be used, before it builds the site. */
        private const val ONLY_ASKED = "robotran.only-asked"

        /** Whether a command that takes the site is to look at its arguments only. */
        fun isOnlyAsked() = System.getProperty(ONLY_ASKED) == "true"

        private const val DEFAULT_PORT = 8080
        private const val HIGHEST_PORT = 65_535
    }
}
