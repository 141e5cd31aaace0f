package robotran.workshop.platform

import robotran.simulation.picture.NoWorldPictures
import robotran.simulation.picture.WorldPictures
import robotran.workshop.sound.LoudSpeaker
import robotran.workshop.sound.NoLoudSpeaker
import kotlin.coroutines.CoroutineContext
import kotlin.coroutines.EmptyCoroutineContext

/** What the app needs of the machine it runs on; one for each window. */
interface Platform {
    /** Plays the brick's tones; is closed with the workshop. */
    val speaker: LoudSpeaker

    /** Where work is kept without anybody asking; one for all windows. */
    val store: KeyValueStore

    /** Where files are opened and saved by a person. */
    val files: FilePicker

    /** How text such as a link leaves the app. */
    val sharing: Sharing

    val clock: WallClock

    /** What is brought to this window. */
    val arrivals: OpenRequests

    /** Whether this window is the first, which goes on with the work that was open last; others begin afresh. */
    val goesOn: Boolean get() = true

    /** What this window knows of itself after it was loaded anew. */
    val window: WindowMemory get() = NoWindowMemory

    /**
     * The address of the page this runs in or belongs to, without a fragment; empty where there is none, so that people
     * are asked for [Settings.site][robotran.workshop.state.Settings.site].
     */
    val pageAddress: String get() = ""

    /** Draws the pictures that are saved. */
    val pictures: WorldPictures

    /** Where long work is done, away from the thread of the screen where there is another. */
    val background: CoroutineContext get() = EmptyCoroutineContext
}

/** A platform that keeps everything in memory and asks nobody: for tests, and where nothing else is there. */
class MemoryPlatform(
    override val speaker: LoudSpeaker = NoLoudSpeaker,
    override val store: KeyValueStore = MemoryStore(),
    override val files: FilePicker = NoFilePicker,
    override val sharing: Sharing = NoSharing,
    override val clock: WallClock = FixedClock(),
    override val arrivals: OpenRequests = OpenRequests(),
    override val window: WindowMemory = NoWindowMemory,
    override val pageAddress: String = "",
    override val pictures: WorldPictures = NoWorldPictures,
) : Platform
