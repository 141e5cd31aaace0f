package robotran.workshop.service

import robotran.language.Language
import robotran.workshop.state.Settings

/** What has happened to the window as a whole. */
sealed interface WindowRoomEvent : RoomEvent {
    /** The settings of this machine are [settings] now. */
    data class SettingsChanged(val settings: Settings) : WindowRoomEvent

    /** The app speaks [language] now, or what comes with it has other words. */
    data class LanguageChanged(val language: Language) : WindowRoomEvent

    /** The pages that cover the workshop are to close, for what a menu of the window has opened over them. */
    data object PagesLeft : WindowRoomEvent
}
