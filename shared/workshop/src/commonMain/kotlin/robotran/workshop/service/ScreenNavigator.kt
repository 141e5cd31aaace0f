package robotran.workshop.service

import robotran.workshop.state.Pane

/** Brings parts of the screen into sight. */
interface ScreenNavigator {
    /** Shows [pane] where there is room for one only. */
    fun show(pane: Pane)

    /** The task of the world is no longer shown over the sheet. */
    fun hideTask()

    /** Opens the settings at the address of the site. */
    fun openSiteSetting()
}
