package robotran.ui.send.hub

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import org.jetbrains.skia.Image
import robotran.language.Language
import robotran.ui.language.InLanguage
import robotran.ui.screen.keepAs
import robotran.ui.screen.onEventThread
import robotran.ui.screen.sceneOf
import robotran.ui.theme.RobotranTheme
import robotran.uikit.*
import robotran.workshop.state.AppTheme
import robotran.workshop.state.HubSendState
import robotran.workshop.state.Settings
import kotlin.test.Test

/** Pictures of the sheet that sends to a hub, for review. */
class HubSendPictures {
    @Test
    fun `every step can be photographed on a phone`() {
        for ((name, step) in HUB_STEPS) photograph(step, Screen.PHONE, Settings()).keepAs("hub-send/phone-$name")
    }

    @Test
    fun `every step can be photographed on all screens, in all languages, dark, and with text twice as large`() {
        for (screen in Screen.entries) {
            for ((name, step) in HUB_STEPS.filterKeys { it in IMPORTANT }) {
                for (language in Language.entries) {
                    val look = Settings(language = language, theme = AppTheme.DARK)
                    photograph(step, screen, look).keepAs("hub-send/${screen.name.lowercase()}-${language.tag}-$name")
                    photograph(step, screen, look.copy(theme = AppTheme.LIGHT, textScale = 2f))
                        .keepAs("hub-send/${screen.name.lowercase()}-${language.tag}-200-$name")
                }
            }
        }
    }
}

private fun photograph(state: HubSendState, screen: Screen, settings: Settings): Image = onEventThread {
    val scene = sceneOf(screen.width, screen.height) {
        InLanguage(settings.language) {
            RobotranTheme(dark = settings.theme == AppTheme.DARK, settings) {
                Box(
                    Modifier.fillMaxSize().background(LocalRobotranColours.current.desk).padding(16.dp),
                    Alignment.Center,
                ) { HubSendCard(state, onEvent = {}) }
            }
        }
    }
    try {
        scene.render()
        scene.render(nanoTime = SECOND)
    } finally {
        scene.close()
    }
}

private enum class Screen(val width: Int, val height: Int) {
    PHONE(411, 891),
    PHONE_ACROSS(891, 411),
    TABLET(1280, 800),
}

private val IMPORTANT =
    setOf(
        "choose",
        "choose-missing",
        "found-low",
        "found-other",
        "sending-again",
        "running-prints",
        "ended-missing_device",
        "no-way",
    )
private const val SECOND = 1_000_000_000L
