package robotran.ui.brick.nxt

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Arrangement
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.Column
import androidx.compose.foundation.layout.Row
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.foundation.layout.width
import androidx.compose.runtime.Composable
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import org.jetbrains.skia.Image
import robotran.language.Language
import robotran.nxt.state.NxtState
import robotran.ui.brick.BrickFront
import robotran.ui.brick.BrickHint
import robotran.ui.brick.BrickStrip
import robotran.ui.golden.GoldenPicture
import robotran.ui.language.InLanguage
import robotran.ui.screen.WorkshopScreen
import robotran.ui.screen.onEventThread
import robotran.ui.screen.sceneOf
import robotran.ui.theme.RobotranTheme
import robotran.uikit.*
import robotran.workshop.state.Pane
import robotran.workshop.state.Settings
import robotran.world.ReadyRobots
import kotlin.test.Test

/** Compares pictures of an NXT with reviewed ones. */
class NxtPictureTest {
    private val states: List<NxtState> =
        with(NxtScenes) { listOf(menu, running, loud, failed, off) }

    @Test
    fun `the front looks as it did in all its states`() = byDayAndNight { name, dark ->
        GoldenPicture.check("nxt-fronts-$name", picture(1_640, 800, dark) { Fronts() })
    }

    @Test
    fun `the strip looks as it did in all its states`() = byDayAndNight { name, dark ->
        GoldenPicture.check("nxt-strips-$name", picture(560, 480, dark) { Strips() })
    }

    @Test
    fun `a phone, a tablet and a laptop show it as they did`() = byDayAndNight { name, dark ->
        for ((screen, width, height) in SCREENS) {
            for ((pane, brick) in listOf(Pane.WORLD to NxtScenes.running, Pane.BRICK to NxtScenes.failed)) {
                val state = NxtScenes.screen(brick, isWhole = pane == Pane.BRICK, pane = pane)
                val seen = picture(width, height, dark) { WorkshopScreen(state, { }) }
                GoldenPicture.check("nxt-$screen-${pane.name.lowercase()}-$name", seen)
            }
        }
    }

    @Composable
    private fun Fronts() = Row(Modifier.padding(20.dp), Arrangement.spacedBy(20.dp)) {
        for (state in states) {
            Column(Modifier.width(300.dp), Arrangement.spacedBy(12.dp)) {
                val robot = if (state === NxtScenes.loud) ReadyRobots.LINE_FOLLOWER else NxtScenes.robot
                BrickFront(state, state.pressed, { }, { }, robot = robot)
                BrickHint(state)
            }
        }
    }

    @Composable
    private fun Strips() = Row(Modifier.padding(20.dp), Arrangement.spacedBy(20.dp)) {
        for (isLow in listOf(false, true)) {
            Column(verticalArrangement = Arrangement.spacedBy(12.dp)) {
                for (state in states) BrickStrip(state, state.pressed, { }, { }, isLow = isLow)
            }
        }
    }

    private fun byDayAndNight(check: (String, Boolean) -> Unit) {
        check("light", false)
        check("dark", true)
    }

    private fun picture(width: Int, height: Int, dark: Boolean, content: @Composable () -> Unit): Image =
        onEventThread {
            val scene = sceneOf(width, height) {
                InLanguage(Language.ENGLISH) {
                    RobotranTheme(dark, Settings(lessMotion = true)) {
                        Box(Modifier.fillMaxSize().background(LocalRobotranColours.current.desk)) { content() }
                    }
                }
            }
            try {
                scene.render()
                scene.render(nanoTime = SECOND)
                scene.render(nanoTime = 60 * SECOND)
            } finally {
                scene.close()
            }
        }

    private companion object {
        const val SECOND = 1_000_000_000L
        val SCREENS = listOf(Triple("phone", 411, 891), Triple("tablet", 1_280, 800), Triple("laptop", 1_440, 900))
    }
}
