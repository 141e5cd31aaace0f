package robotran.desktop.platform

import kotlinx.coroutines.Dispatchers
import robotran.desktoptower.DesktopTowerPorts
import robotran.desktoptower.hub.DesktopHubPorts
import robotran.desktoptower.microbit.DesktopMicrobitDrives
import robotran.hublink.connection.HubPorts
import robotran.microbitlink.drive.MicrobitDrives
import robotran.mpycompiler.JvmMpyCompiler
import robotran.mpycompiler.MpyCompiler
import robotran.simulation.picture.WorldPictures
import robotran.tower.port.TowerPorts
import robotran.ui.pictures.DrawnWorldPictures
import robotran.ui.pictures.SkiaPhotoReader
import robotran.ui.platform.JavaClock
import robotran.workshop.platform.FilePicker
import robotran.workshop.platform.GradingThreads
import robotran.workshop.platform.GradingWorkers
import robotran.workshop.platform.KeyValueStore
import robotran.workshop.platform.OpenRequests
import robotran.workshop.platform.OpeningMarks
import robotran.workshop.platform.PhotoReader
import robotran.workshop.platform.PictureQrScanner
import robotran.workshop.platform.Platform
import robotran.workshop.platform.Posters
import robotran.workshop.platform.QrScanner
import robotran.workshop.platform.Sharing
import robotran.workshop.platform.WallClock
import robotran.workshop.platform.WebSite
import robotran.workshop.sound.LoudSpeaker
import kotlin.coroutines.CoroutineContext

/** The services of the desktop for one window. */
internal class DesktopPlatform(
    override val speaker: LoudSpeaker,
    override val store: KeyValueStore,
    override val files: FilePicker,
    override val openRequests: OpenRequests,
    override val restoresLastProject: Boolean,
    override val openingMarks: OpeningMarks,
) : Platform {
    override val showsRecentFiles: Boolean get() = true
    override val pictures: WorldPictures = DrawnWorldPictures()
    override val posters: Posters = DesktopPosters
    override val webSite: WebSite? = FolderWebSite.ofThisProcess()
    override val sharing: Sharing = Clipboard
    override val clock: WallClock = JavaClock
    override val towers: TowerPorts = DesktopTowerPorts()
    override val hubs: HubPorts = DesktopHubPorts()
    override val microbitDrives: MicrobitDrives = DesktopMicrobitDrives()
    override val mpyCompiler: MpyCompiler = JvmMpyCompiler()
    override val gradingWorkers: GradingWorkers = GradingThreads()
    override val qrScanner: QrScanner = PictureQrScanner(files, Dispatchers.IO, pixelsIn = ::pixelsIn)
    override val photoReader: PhotoReader = SkiaPhotoReader
    override val prefersLessMotion: Boolean get() = SystemMotion.isReduced
    override val background: CoroutineContext = Dispatchers.Default
}
