package robotran.ui.desktop

import java.awt.Component
import java.awt.Container
import java.awt.Toolkit
import java.awt.event.KeyEvent
import javax.swing.JFrame
import javax.swing.SwingUtilities

/**
 * Does in [window] what the platform's shortcut with the key [code] does where the focus of Compose is, once the menu
 * that this was chosen in has given the keyboard back. Only what draws the window is told of the keys: the menu has the
 * same shortcuts and would be chosen once more.
 */
internal fun pressShortcut(window: JFrame, code: Int) = SwingUtilities.invokeLater {
    val drawn = listeningIn(window.contentPane) ?: return@invokeLater
    val modifiers = Toolkit.getDefaultToolkit().menuShortcutKeyMaskEx
    val time = System.currentTimeMillis()
    val pressed = KeyEvent(drawn, KeyEvent.KEY_PRESSED, time, modifiers, code, KeyEvent.CHAR_UNDEFINED)
    val released = KeyEvent(drawn, KeyEvent.KEY_RELEASED, time, modifiers, code, KeyEvent.CHAR_UNDEFINED)
    drawn.keyListeners.forEach { it.keyPressed(pressed) }
    drawn.keyListeners.forEach { it.keyReleased(released) }
}

/** What is told of keys: the one component that Compose draws into. */
private fun listeningIn(component: Component): Component? = component.takeIf { it.keyListeners.isNotEmpty() }
    ?: (component as? Container)?.components?.firstNotNullOfOrNull(::listeningIn)
