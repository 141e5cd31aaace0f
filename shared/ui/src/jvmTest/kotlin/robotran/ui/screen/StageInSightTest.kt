package robotran.ui.screen

/** Each seventh lesson and world, on one window; `thorough` tests all of them on all windows. */
class StageInSightTest : StageInSight() {
    override fun windowsOf(number: Int): List<Pair<Int, Int>> =
        if (number % 7 == 0) listOf(WINDOWS[number / 7 % WINDOWS.size]) else emptyList()
}
