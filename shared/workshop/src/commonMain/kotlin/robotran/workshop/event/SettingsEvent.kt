package robotran.workshop.event

import robotran.workshop.state.Settings
import robotran.workshop.state.WindowForm

/** A user action on the settings of this machine. */
sealed interface SettingsEvent : WorkshopEvent {
    /** Changes the settings to [settings] and stores them. */
    data class SettingsChanged(val settings: Settings) : SettingsEvent

    /** Gives blocks and programs of the app the words of English, or those of the app language. */
    data class WordsChosen(val inEnglish: Boolean) : SettingsEvent

    /** Turns all sound on or off. */
    data class SoundSwitched(val on: Boolean) : SettingsEvent

    /** Gives the program this part of windows of this [form]; null for as much as Robotran would. */
    data class ProgramShareChosen(val form: WindowForm, val share: Float?) : SettingsEvent

    /** Shows the whole brick, or only its display and Run, in windows of this [form]. */
    data class BrickSizeChosen(val form: WindowForm, val isWhole: Boolean) : SettingsEvent

    /** Shows or hides the settings page. */
    data class SettingsShown(val shown: Boolean) : SettingsEvent

    /** Shows the settings page at the base URL of links. */
    data object SiteRequested : SettingsEvent
}
