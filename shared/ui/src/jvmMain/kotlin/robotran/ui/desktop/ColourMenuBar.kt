package robotran.ui.desktop

import androidx.compose.ui.graphics.toArgb
import robotran.uikit.*
import java.awt.Color
import java.awt.Component
import java.awt.Container
import javax.swing.JComponent
import javax.swing.JFrame
import javax.swing.JMenu
import javax.swing.SwingUtilities

/** Gives the menu bar of [window], which Swing draws, the app's [colours] once its items are there. */
internal fun colourMenuBar(window: JFrame, colours: RobotranColours) = SwingUtilities.invokeLater {
    val bar = window.jMenuBar ?: return@invokeLater
    colour(bar, Color(colours.pane.toArgb()), Color(colours.onPane.toArgb()))
    bar.repaint()
}

private fun colour(component: Component, background: Color, foreground: Color) {
    component.background = background
    component.foreground = foreground
    if (component is JComponent) component.isOpaque = true
    if (component is JMenu) colour(component.popupMenu, background, foreground)
    if (component is Container) component.components.forEach { colour(it, background, foreground) }
}
