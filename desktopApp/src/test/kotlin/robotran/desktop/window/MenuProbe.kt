package robotran.desktop.window

import androidx.compose.foundation.text.BasicTextField
import androidx.compose.runtime.LaunchedEffect
import androidx.compose.runtime.getValue
import androidx.compose.runtime.mutableStateOf
import androidx.compose.runtime.remember
import androidx.compose.runtime.setValue
import androidx.compose.ui.Modifier
import androidx.compose.ui.awt.ComposeWindow
import androidx.compose.ui.focus.FocusRequester
import androidx.compose.ui.focus.focusRequester
import androidx.compose.ui.window.Window
import androidx.compose.ui.window.application
import kotlinx.coroutines.delay
import kotlinx.coroutines.runBlocking
import robotran.language.Language
import robotran.ui.desktop.WorkshopMenuBar
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import javax.swing.JMenu
import javax.swing.JMenuItem
import javax.swing.SwingUtilities

/**
 * Opens a window with the app's menu over a text field, changes the language and edits by menu. Prints one line per
 * result. Runs in its own process on a given display.
 */
fun main() {
    val workshop = runBlocking { openWorkshop() }
    application(exitProcessOnExit = false) {
        Window(::exitApplication) {
            var text by remember { mutableStateOf("pen down") }
            val focus = remember { FocusRequester() }
            WorkshopMenuBar(workshop.state, workshop::handle, {}, {}, {})
            BasicTextField(text, { text = it }, Modifier.focusRequester(focus))
            LaunchedEffect(Unit) {
                for (language in listOf(Language.ENGLISH, Language.GERMAN, Language.SPANISH, Language.ENGLISH)) {
                    workshop.handle(SettingsEvent.SettingsChanged(workshop.state.settings.copy(language = language)))
                    delay(MOMENT)
                    println("$language: ${menus(window)}")
                }
                focus.requestFocus()
                delay(MOMENT)
                for (shortcut in listOf("A", "C", "X", "V", "V")) {
                    choose(window, shortcut)
                    delay(MOMENT)
                    println("$shortcut: $text")
                }
                exitApplication()
            }
        }
    }
}

private fun menus(window: ComposeWindow): List<String> = window.jMenuBar.components.filterIsInstance<JMenu>().map {
    if (it.isShowing && it.height > 0) {
        it.text
    } else {
        "${it.text} out of sight"
    }
}

/** Selects the item with the shortcut [letter] in the second menu, like a click. */
private fun choose(window: ComposeWindow, letter: String) {
    val items = window.jMenuBar.getMenu(1).menuComponents.filterIsInstance<JMenuItem>()
    val item = items.single { it.accelerator?.keyCode == letter.single().code && "shift" !in it.accelerator.toString() }
    SwingUtilities.invokeLater(item::doClick)
}

private const val MOMENT = 700L
