package robotran.ui

import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.padding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.rememberCoroutineScope
import androidx.compose.runtime.setValue
import androidx.compose.ui.Alignment
import androidx.compose.ui.Modifier
import androidx.compose.ui.unit.dp
import robotran.programs.Program
import robotran.ui.pictures.DrawnWorldPictures
import robotran.ui.screen.texts.ScreenTexts
import robotran.ui.theme.RobotranTheme
import robotran.uikit.*
import robotran.workshop.Workshop
import robotran.workshop.openWorkshop
import robotran.workshop.platform.MemoryPlatform
import robotran.workshop.platform.Platform

/**
 * The root of every platform's app: a loading message, then [RobotranApp] with [programs] or, if empty, the square.
 *
 * @param platform the platform services; must not change.
 * @param welcoming see [openWorkshop].
 * @param embedded see [RobotranApp].
 * @param onOpened receives the workshop once it is loaded.
 */
@Composable
fun RobotranStart(
    programs: List<Program> = emptyList(),
    platform: Platform = remember { MemoryPlatform(pictures = DrawnWorldPictures()) },
    welcoming: Boolean = false,
    embedded: Boolean = false,
    onOpened: (Workshop) -> Unit = {},
) {
    val scope = rememberCoroutineScope()
    var workshop by remember { mutableStateOf<Workshop?>(null) }
    LaunchedEffect(programs) {
        workshop = openWorkshop(programs, platform, scope, welcoming).also(onOpened)
    }
    DisposableEffect(Unit) { onDispose { workshop?.close() } }
    RobotranWindow(workshop, embedded)
}

/** The content of a window whose caller owns [workshop]; null while it is loading. */
@Composable
fun RobotranWindow(workshop: Workshop?, embedded: Boolean = false) {
    if (workshop == null) RobotranTheme { LoadingMessage() } else RobotranApp(workshop, embedded = embedded)
}

@Composable
private fun LoadingMessage() {
    val colours = LocalRobotranColours.current
    Box(Modifier.fillMaxSize().background(colours.desk).padding(24.dp), Alignment.Center) {
        Text(ScreenTexts.loading(spoken), style = TextStyles.lead, color = colours.onPane)
    }
}
