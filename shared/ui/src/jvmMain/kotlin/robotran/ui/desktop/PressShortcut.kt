package robotran.ui.desktop

import java.awt.Component
import java.awt.Container
import java.awt.Toolkit
import java.awt.event.KeyEvent
import javax.swing.JFrame
import javax.swing.SwingUtilities

/**
 * Performs the platform's shortcut with the key [code] in [window], at Compose's focus, after the menu has returned the
 * focus. Only Compose's component receives the key events: the menu has the same shortcut and would be triggered again.
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

/** The component that receives key events, into which Compose draws. */
private fun listeningIn(component: Component): Component? = component.takeIf { it.keyListeners.isNotEmpty() }
    ?: (component as? Container)?.components?.firstNotNullOfOrNull(::listeningIn)
