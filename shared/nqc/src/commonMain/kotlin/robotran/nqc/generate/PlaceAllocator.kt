package robotran.nqc.generate

import robotran.legofirmware.image.FirmwareLimits
import robotran.legofirmware.image.FirmwareTarget

/** What code variables are allocated for. */
internal enum class AllocationMode {
    /** Variables outside of tasks. */
    GLOBAL,
    TASK,

    /** A subroutine that one task calls, or none. */
    SUB_OF_ONE_TASK,

    /** A subroutine that several tasks call: it may not have variables that they share. */
    SUB_OF_MANY_TASKS,
}

/**
 * Gives variables their numbers in the brick, in the order of the original compiler: tasks from the last local variable
 * downwards, subroutines from the first one upwards, and global variables when those are full.
 */
internal class PlaceAllocator(target: FirmwareTarget) {
    private enum class State(val isFree: Boolean) {
        FREE(true),

        /** Free, but used before by the same task or subroutine. */
        USED_BEFORE(true),
        USED(false),
        TEMPORARY(false),
        RESERVED(false),
    }

    private val locals = if (target == FirmwareTarget.RCX2) FirmwareLimits.LOCAL_VARIABLES else 0
    private val states = MutableList(FirmwareLimits.GLOBAL_VARIABLES + locals) { State.FREE }
    private val globalPlaces = 0 until FirmwareLimits.GLOBAL_VARIABLES
    private val localPlaces = FirmwareLimits.GLOBAL_VARIABLES until states.size
    var mode = AllocationMode.GLOBAL
        private set

    /** Takes the variables [places] away for good; false if one does not exist or is taken. */
    fun reserve(places: IntRange): Boolean {
        if (places.isEmpty() || places.first < 0 || places.last >= states.size) return false
        return places.all { place ->
            val isFree = states[place] == State.FREE
            if (isFree) states[place] = State.RESERVED
            isFree
        }
    }

    /** Begins a task or subroutine: all local variables are free. */
    fun begin(mode: AllocationMode) {
        this.mode = mode
        for (place in localPlaces) if (states[place] != State.RESERVED) states[place] = State.FREE
    }

    /** Ends it: nobody else may use its global variables. Returns the local ones that it used. */
    fun end(): Set<Int> {
        for (place in globalPlaces) {
            if (states[place] == State.USED_BEFORE || states[place] == State.TEMPORARY) states[place] = State.USED
        }
        mode = AllocationMode.GLOBAL
        return localPlaces.filter { states[it] != State.FREE && states[it] != State.RESERVED }.toSet()
    }

    /** Allocates [size] variables in a row and returns the first; null if there is no room. */
    fun allocate(size: Int, isTemporary: Boolean, allowsLocals: Boolean = true): Int? {
        val place = find(size, allowsLocals) ?: return null
        for (offset in 0 until size) states[place + offset] = if (isTemporary) State.TEMPORARY else State.USED
        return place
    }

    private fun find(size: Int, allowsLocals: Boolean): Int? {
        val upwards = localPlaces.first..localPlaces.last - size + 1
        val local = when {
            !allowsLocals || mode == AllocationMode.GLOBAL -> null
            mode == AllocationMode.TASK -> upwards.reversed().find { isFree(it, size) }
            else -> upwards.find { isFree(it, size) }
        }
        val mayUseGlobals = mode != AllocationMode.SUB_OF_MANY_TASKS
        return local ?: if (mayUseGlobals) (0..globalPlaces.last - size + 1).find { isFree(it, size) } else null
    }

    private fun isFree(index: Int, size: Int) = (index until index + size).all { states[it].isFree }

    fun release(index: Int) {
        if (states.getOrNull(index) == State.USED || isTemporary(index)) states[index] = State.USED_BEFORE
    }

    fun isTemporary(index: Int): Boolean = states.getOrNull(index) == State.TEMPORARY

    fun isLocal(index: Int): Boolean = index >= localPlaces.first

    /** Whether none of these [places] is in use. */
    fun areFree(places: Set<Int>): Boolean = places.all { states[it].isFree }
}
