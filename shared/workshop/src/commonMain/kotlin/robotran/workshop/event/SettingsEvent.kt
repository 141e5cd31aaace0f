package robotran.workshop.event

import robotran.workshop.state.Settings

/** Something a person wants to be different on this machine. */
sealed interface SettingsEvent : WorkshopEvent {
    /** The settings are to be [settings] from now on, and the next time. */
    data class SettingsChanged(val settings: Settings) : SettingsEvent

    /** The brick's tones are to be heard or not. */
    data class SoundSwitched(val on: Boolean) : SettingsEvent

    /** The page with the settings is to be shown or not. */
    data class SettingsShown(val shown: Boolean) : SettingsEvent

    /** The page with the settings is to be shown where the address of the site is chosen. */
    data object SiteRequested : SettingsEvent
}
