package robotran.nxt.natives

import robotran.nxt.display.ByteArrayMemory
import robotran.nxt.display.DisplayMemory
import robotran.nxt.display.DisplaySize
import robotran.nxt.display.Drawing
import robotran.nxt.display.NxtDisplay
import robotran.nxt.display.copyOf
import robotran.nxt.hardware.Clock
import robotran.nxt.state.NxtState

/**
 * The display: memory that a program draws into, and glass that shows it after a refresh. The brick refreshes by itself
 * every [autoRefreshPeriod].
 */
internal class DisplayPart(private val clock: Clock) {
    private val own = ByteArrayMemory(ByteArray(DisplaySize.BYTES))

    /** What a refresh copies. */
    var memory: DisplayMemory = own

    /** What can be seen. The same object until that changes. */
    var glass: NxtDisplay = NxtDisplay.BLANK
        private set

    /** Milliseconds; 0 if the brick does not refresh by itself. */
    var autoRefreshPeriod = NORMAL_PERIOD
        private set

    var contrast = NxtState.HIGHEST_CONTRAST
        private set

    /** When the last refresh is complete. */
    var refreshCompleteTime = 0L
        private set

    private var nextRefresh = NORMAL_PERIOD.toLong()
    private var copied: ByteArray? = null
    private var isRequestedAgain = false

    /** Begins to copy the memory to the glass, or does so after the copy that is under way. */
    fun refresh() {
        if (copied == null) begin() else requestAgain()
    }

    /** Sets the period, at least [REFRESH_MILLISECONDS] or 0 for none, and returns the one before. */
    fun setAutoRefreshPeriod(milliseconds: Int): Int {
        val old = autoRefreshPeriod
        autoRefreshPeriod = if (milliseconds <= 0) 0 else maxOf(milliseconds, REFRESH_MILLISECONDS)
        nextRefresh = clock.milliseconds() + autoRefreshPeriod
        return old
    }

    fun setContrast(contrast: Int) {
        this.contrast = contrast.coerceIn(0, NxtState.HIGHEST_CONTRAST)
    }

    fun tick() {
        val now = clock.milliseconds()
        val bytes = copied
        if (bytes != null && now >= refreshCompleteTime - (if (isRequestedAgain) REFRESH_MILLISECONDS else 0)) {
            copied = null
            show(bytes)
            if (isRequestedAgain) begin()
        }
        if (autoRefreshPeriod > 0 && now >= nextRefresh) {
            nextRefresh = now + autoRefreshPeriod
            if (copied == null) begin()
        }
    }

    /**
     * What can be seen as soon as a refresh that the brick makes by itself or that has begun is complete. Ask it while
     * the memory is still the program's.
     */
    fun drawn(): NxtDisplay {
        val bytes = if (autoRefreshPeriod > 0 || isRequestedAgain) copyOf(memory) else copied ?: return glass
        return if (glass.hasBytes(bytes)) glass else NxtDisplay(bytes)
    }

    /** Shows at once what [draw] makes of a clear display, with the brick's own memory and settings. */
    fun showOwn(draw: (DisplayMemory) -> Unit) {
        Drawing.clear(own)
        draw(own)
        reset()
        show(copyOf(own))
    }

    /** What a program finds when it starts: a clear display and the usual refresh. */
    fun clearForProgram() = showOwn { }

    private fun reset() {
        memory = own
        copied = null
        isRequestedAgain = false
        autoRefreshPeriod = NORMAL_PERIOD
        contrast = NxtState.HIGHEST_CONTRAST
        nextRefresh = clock.milliseconds() + NORMAL_PERIOD
    }

    private fun begin() {
        copied = copyOf(memory)
        isRequestedAgain = false
        refreshCompleteTime = clock.milliseconds() + REFRESH_MILLISECONDS
    }

    private fun requestAgain() {
        if (isRequestedAgain) return
        isRequestedAgain = true
        refreshCompleteTime += REFRESH_MILLISECONDS
    }

    private fun show(bytes: ByteArray) {
        if (!glass.hasBytes(bytes)) glass = NxtDisplay(bytes)
    }

    private companion object {
        const val NORMAL_PERIOD = 250
        const val REFRESH_MILLISECONDS = 6
    }
}
