package robotran.cli

import robotran.cli.console.DesktopApp
import robotran.console.ExitCode
import robotran.simulation.picture.NoWorldPictures
import robotran.simulation.picture.WorldPictures
import robotran.simulation.state.SessionState
import robotran.world.World

/** A fake desktop app that records the opened files. Its pictures contain the world's title. */
internal class TestDesktop(private val answer: ExitCode = ExitCode.NO_DISPLAY) : DesktopApp {
    val opened = mutableListOf<List<String>>()

    override val pictures =
        object : WorldPictures {
            override fun png(world: World, state: SessionState): ByteArray = "png of ${world.title}".encodeToByteArray()

            override fun svg(world: World, state: SessionState): String = "svg of ${world.title}"

            override fun frames(world: World, maxSide: Int) = NoWorldPictures.frames(world, maxSide)
        }

    override fun openWindow(files: List<String>): ExitCode {
        opened += files
        return answer
    }
}
