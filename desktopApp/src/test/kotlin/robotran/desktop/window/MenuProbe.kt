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
import androidx.compose.ui.focus.onFocusChanged
import androidx.compose.ui.text.input.TextFieldValue
import androidx.compose.ui.window.Window
import androidx.compose.ui.window.application
import kotlinx.coroutines.delay
import kotlinx.coroutines.runBlocking
import kotlinx.coroutines.withTimeoutOrNull
import robotran.language.Language
import robotran.ui.desktop.WorkshopMenuBar
import robotran.workshop.event.SettingsEvent
import robotran.workshop.openWorkshop
import java.awt.Toolkit
import java.awt.datatransfer.DataFlavor
import javax.swing.JMenu
import javax.swing.JMenuItem
import javax.swing.SwingUtilities
import kotlin.time.Duration.Companion.milliseconds
import kotlin.time.Duration.Companion.seconds

/**
 * Opens a window with the app's menu over a text field, changes the language and edits by menu. Prints one line per
 * result, as soon as it is there or after [PATIENCE]. Runs in its own process on a given display.
 */
fun main() {
    val workshop = runBlocking { openWorkshop() }
    application(exitProcessOnExit = false) {
        Window(::exitApplication) {
            var field by remember { mutableStateOf(TextFieldValue("pen down")) }
            var hasFocus by remember { mutableStateOf(false) }
            val focus = remember { FocusRequester() }
            WorkshopMenuBar(workshop.state, workshop::handle, {}, {}, {})
            val modifier = Modifier.focusRequester(focus).onFocusChanged { hasFocus = it.isFocused }
            BasicTextField(field, { field = it }, modifier)
            LaunchedEffect(Unit) {
                var last = emptyList<String>()
                for (language in listOf(Language.ENGLISH, Language.GERMAN, Language.SPANISH, Language.ENGLISH)) {
                    workshop.handle(SettingsEvent.SettingsChanged(workshop.state.settings.copy(language = language)))
                    until { menus(window).let { menus -> menus != last && menus.none { OUT_OF_SIGHT in it } } }
                    last = menus(window)
                    println("$language: $last")
                }
                focus.requestFocus()
                until { hasFocus }
                val results = listOf<Pair<String, () -> Boolean>>(
                    "A" to { field.selection.length == field.text.length },
                    "C" to { clipboardText() == field.text },
                    "X" to { field.text.isEmpty() },
                    "V" to { field.text.isNotEmpty() },
                    "V" to { field.text.length > "pen down".length },
                )
                for ((shortcut, isDone) in results) {
                    choose(window, shortcut)
                    until(isDone)
                    println("$shortcut: ${field.text}")
                }
                exitApplication()
            }
        }
    }
}

private suspend fun until(isDone: () -> Boolean) {
    withTimeoutOrNull(PATIENCE) { while (!isDone()) delay(20.milliseconds) }
}

private fun clipboardText(): String? = runCatching {
    Toolkit.getDefaultToolkit().systemClipboard.getData(DataFlavor.stringFlavor) as String
}.getOrNull()

private fun menus(window: ComposeWindow): List<String> =
    window.jMenuBar?.components.orEmpty().filterIsInstance<JMenu>().map {
        if (it.isShowing && it.height > 0) it.text else "${it.text} $OUT_OF_SIGHT"
    }

/** Selects the item with the shortcut [letter] in the second menu, like a click. */
private fun choose(window: ComposeWindow, letter: String) {
    val items = window.jMenuBar.getMenu(1).menuComponents.filterIsInstance<JMenuItem>()
    val item = items.single { it.accelerator?.keyCode == letter.single().code && "shift" !in it.accelerator.toString() }
    SwingUtilities.invokeLater(item::doClick)
}

private const val OUT_OF_SIGHT = "out of sight"

private val PATIENCE = 30.seconds
