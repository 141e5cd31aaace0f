package robotran.workshop.platform

import robotran.hublink.connection.HubPorts
import robotran.hublink.connection.NoHubPorts
import robotran.microbitlink.dap.MicrobitPorts
import robotran.microbitlink.dap.NoMicrobitPorts
import robotran.microbitlink.drive.MicrobitDrives
import robotran.microbitlink.drive.NoMicrobitDrives
import robotran.mpycompiler.MpyCompiler
import robotran.simulation.picture.NoWorldPictures
import robotran.simulation.picture.WorldPictures
import robotran.tower.port.NoTowerPorts
import robotran.tower.port.TowerPorts
import robotran.workshop.sound.LoudSpeaker
import robotran.workshop.sound.NoLoudSpeaker
import kotlin.coroutines.CoroutineContext
import kotlin.coroutines.EmptyCoroutineContext

/** The platform services of one window. */
interface Platform {
    /** Plays the brick's tones; closed with the workshop. */
    val speaker: LoudSpeaker

    /** The store for autosaved projects, shared by all windows. */
    val store: KeyValueStore

    /** Opens and saves files chosen by the user. */
    val files: FilePicker

    /** Shares text such as a link. */
    val sharing: Sharing

    val clock: WallClock

    /** Requests to open files and links in this window. */
    val openRequests: OpenRequests

    /** Whether this is the first window, which restores the last project; other windows start a new one. */
    val restoresLastProject: Boolean get() = true

    /** The marks of what is being opened, shared by all windows. */
    val openingMarks: OpeningMarks get() = NoOpeningMarks

    /** The state that this window restores after a reload. */
    val window: WindowMemory get() = NoWindowMemory

    /**
     * The URL of the page that this app runs in or belongs to, without a fragment. If empty, the user is asked for
     * [Settings.site][robotran.workshop.state.Settings.site].
     */
    val pageAddress: String get() = ""

    /** Whether the platform's menu has the files that were used last. */
    val showsRecentFiles: Boolean get() = false

    /** Whether the pupil works with fingers and has no keyboard, so that programs are shown in blocks first. */
    val isForFingers: Boolean get() = false

    /**
     * Whether the user has told the system to move less on the screen. It may change at any time, and Compose observes
     * it.
     */
    val prefersLessMotion: Boolean get() = false

    /** Renders the pictures that are saved. */
    val pictures: WorldPictures

    /** Reads the photos that are made smaller for an assignment. */
    val photoReader: PhotoReader get() = NoPhotoReader

    /** Records videos, where the platform can. */
    val videos: VideoRecorder get() = NoVideoRecorder

    /** Writes and prints posters. */
    val posters: Posters get() = NoPosters

    /** The web site, for packages that contain it; null if there is none at hand. */
    val webSite: WebSite? get() = null

    /** The infrared towers that reach a real RCX. */
    val towers: TowerPorts get() = NoTowerPorts

    /** How real hubs with Pybricks are reached. */
    val hubs: HubPorts get() = NoHubPorts

    /** How a micro:bit at USB is reached. */
    val microbits: MicrobitPorts get() = NoMicrobitPorts

    /** The drives as which boards show themselves, where the app may write to drives. */
    val microbitDrives: MicrobitDrives get() = NoMicrobitDrives

    /** Compiles programs for hubs; null where nothing does. It may load its compiler with the first program. */
    val mpyCompiler: MpyCompiler? get() = null

    /** Grade hand-ins beside the UI thread; null if only that thread can. */
    val gradingWorkers: GradingWorkers? get() = null

    /** Reads QR codes; null where that is not possible. */
    val qrScanner: QrScanner? get() = null

    /** The context for long work, off the UI thread if possible. */
    val background: CoroutineContext get() = EmptyCoroutineContext

    /** Whether a slow compiler may work beside the caller; if not, all results come on the caller's thread. */
    val compilesBeside: Boolean get() = true
}

/** A platform that keeps everything in memory and shows no dialogs, for tests and as a fallback. */
class MemoryPlatform(
    override val speaker: LoudSpeaker = NoLoudSpeaker,
    override val store: KeyValueStore = MemoryStore(),
    override val files: FilePicker = NoFilePicker,
    override val sharing: Sharing = NoSharing,
    override val clock: WallClock = FixedClock(),
    override val openRequests: OpenRequests = OpenRequests(),
    override val window: WindowMemory = NoWindowMemory,
    override val pageAddress: String = "",
    override val pictures: WorldPictures = NoWorldPictures,
    override val towers: TowerPorts = NoTowerPorts,
    override val isForFingers: Boolean = false,
    override val videos: VideoRecorder = NoVideoRecorder,
    override val posters: Posters = NoPosters,
    override val webSite: WebSite? = null,
    override val gradingWorkers: GradingWorkers? = null,
    override val qrScanner: QrScanner? = null,
    override val openingMarks: OpeningMarks = NoOpeningMarks,
    override val showsRecentFiles: Boolean = false,
    override val prefersLessMotion: Boolean = false,
    override val photoReader: PhotoReader = NoPhotoReader,
    override val hubs: HubPorts = NoHubPorts,
    override val mpyCompiler: MpyCompiler? = null,
    override val microbits: MicrobitPorts = NoMicrobitPorts,
    override val microbitDrives: MicrobitDrives = NoMicrobitDrives,
) : Platform {
    override val compilesBeside: Boolean get() = false
}
