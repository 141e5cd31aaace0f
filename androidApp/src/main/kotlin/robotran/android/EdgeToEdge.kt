package robotran.android

import android.graphics.Color
import androidx.activity.ComponentActivity
import androidx.activity.SystemBarStyle
import androidx.activity.enableEdgeToEdge
import androidx.compose.foundation.background
import androidx.compose.foundation.layout.Box
import androidx.compose.foundation.layout.fillMaxSize
import androidx.compose.foundation.layout.safeDrawingPadding
import androidx.compose.runtime.Composable
import androidx.compose.runtime.DisposableEffect
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.derivedStateOf
import androidx.compose.runtime.getValue
import androidx.compose.runtime.remember
import androidx.compose.ui.Modifier
import androidx.compose.ui.platform.LocalView
import robotran.ui.RobotranApp
import robotran.ui.theme.RobotranTheme
import robotran.uikit.*
import robotran.workshop.Workshop

/**
 * The [workshop] in the whole window of [activity]. Controls stay clear of system bars, camera cut-outs and the
 * keyboard.
 */
@Composable
internal fun EdgeToEdge(activity: ComponentActivity, workshop: Workshop) {
    RobotranTheme(settings = workshop.settings) {
        val colours = LocalRobotranColours.current
        LaunchedEffect(colours.isDark) {
            // The icons of the bars need contrast with the app's theme, not with the system's.
            val style = SystemBarStyle.auto(Color.TRANSPARENT, Color.TRANSPARENT) { colours.isDark }
            activity.enableEdgeToEdge(style, style)
        }
        Box(Modifier.fillMaxSize().background(colours.pane).safeDrawingPadding()) { RobotranApp(workshop) }
    }
    StayingAwake(workshop)
}

/** Keeps the screen on while a program runs. */
@Composable
private fun StayingAwake(workshop: Workshop) {
    val view = LocalView.current
    val runs by remember(workshop) { derivedStateOf { workshop.state.run.let { it.running && !it.isPaused } } }
    DisposableEffect(view, runs) {
        view.keepScreenOn = runs
        onDispose { view.keepScreenOn = false }
    }
}
