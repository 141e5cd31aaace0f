package robotran.ui

import androidx.compose.foundation.isSystemInDarkTheme
import androidx.compose.runtime.Composable
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.snapshotFlow
import androidx.compose.runtime.withFrameNanos
import kotlinx.coroutines.flow.collectLatest
import robotran.ui.language.InLanguage
import robotran.ui.screen.EmbedScreen
import robotran.ui.screen.WorkshopScreen
import robotran.ui.theme.RobotranTheme
import robotran.workshop.Workshop
import robotran.workshop.platform.appLanguage

/**
 * The whole app for [workshop]: its screen, the frames that advance time while needed, and the compilation of Java in
 * the pauses of typing.
 *
 * @param embedded whether it is embedded in another page and shows only the world and the brick.
 * @param isRightToLeft whether it is read from right to left, for a language that the app does not speak yet.
 */
@Composable
fun RobotranApp(
    workshop: Workshop,
    dark: Boolean = isSystemInDarkTheme(),
    embedded: Boolean = false,
    isRightToLeft: Boolean = appLanguage(workshop.settings.language).isRightToLeft,
) {
    LaunchedEffect(workshop) {
        snapshotFlow { workshop.isAwake }.collectLatest { awake ->
            if (awake) while (true) withFrameNanos(workshop::frame)
        }
    }
    LaunchedEffect(workshop) { workshop.runCompiler() }
    LaunchedEffect(workshop) { workshop.runAutosave() }
    LaunchedEffect(workshop) { workshop.runOpeningGuard() }
    val settings = workshop.settings
    InLanguage(settings.language, isRightToLeft) {
        RobotranTheme(dark, settings, workshop.hasLessMotion) {
            if (embedded) {
                EmbedScreen(
                    workshop.state,
                    workshop::handle,
                )
            } else {
                WorkshopScreen(workshop.state, workshop::handle)
            }
        }
    }
}
