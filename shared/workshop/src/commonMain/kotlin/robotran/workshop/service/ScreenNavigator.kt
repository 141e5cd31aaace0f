package robotran.workshop.service

import robotran.workshop.state.Pane

/** Shows parts of the screen. */
interface ScreenNavigator {
    /** Shows [pane] on screens with room for only one. */
    fun show(pane: Pane)

    /** Hides the task of the world above the sheet. */
    fun hideTask()

    /** Leaves the pages that cover the workshop, for what a menu of the window has opened over them. */
    fun leavePages()

    /** Opens the settings page at the base URL of links. */
    fun openSiteSetting()
}
