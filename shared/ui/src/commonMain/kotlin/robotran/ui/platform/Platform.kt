package robotran.ui.platform

import robotran.ui.sound.LoudSpeaker
import robotran.ui.sound.NoLoudSpeaker

/** What the app needs of the machine it runs on. */
interface Platform {
    /** Plays the brick's tones; is closed with the workshop. */
    val speaker: LoudSpeaker

    /** Where work is kept without anybody asking. */
    val store: WorkStore

    /** Where files are opened and saved by a person. */
    val files: FileDesk

    /** How text such as a link leaves the app. */
    val sharing: Sharing
}

/** A platform that keeps everything in memory and asks nobody: for tests, and where nothing else is there. */
class MemoryPlatform(
    override val speaker: LoudSpeaker = NoLoudSpeaker,
    override val store: WorkStore = MemoryStore(),
    override val files: FileDesk = NoFileDesk,
    override val sharing: Sharing = NoSharing,
) : Platform
