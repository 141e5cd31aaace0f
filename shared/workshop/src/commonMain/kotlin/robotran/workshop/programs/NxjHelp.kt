package robotran.workshop.programs

import robotran.nxjlibrary.NxjSources
import kotlin.coroutines.cancellation.CancellationException

/** Loads what completion and help say about leJOS NXJ; null if a browser cannot fetch it now. */
internal suspend fun nxjSources(): NxjSources? = try {
    NxjSources.load()
} catch (cancelled: CancellationException) {
    throw cancelled
} catch (_: Throwable) {
    // The exception's type depends on the platform.
    null
}
