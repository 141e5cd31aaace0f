package robotran.workshop.event

import robotran.workshop.state.Settings

/** A user action on the settings of this machine. */
sealed interface SettingsEvent : WorkshopEvent {
    /** Changes the settings to [settings] and stores them. */
    data class SettingsChanged(val settings: Settings) : SettingsEvent

    /** Turns the brick's sound on or off. */
    data class SoundSwitched(val on: Boolean) : SettingsEvent

    /** Shows or hides the settings page. */
    data class SettingsShown(val shown: Boolean) : SettingsEvent

    /** Shows the settings page at the base URL of links. */
    data object SiteRequested : SettingsEvent
}
