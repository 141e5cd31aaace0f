package robotran.rom

/**
 * The one seam between a program and the robot: everything a program does to the robot is a [call] of a ROM routine,
 * everything it senses is read from [memory], where the routines leave their results, as on a real RCX.
 */
interface Rom {
    /** The brick's 64 KB address space; ROM routines with a pointer argument read and write here. */
    val memory: RcxMemory

    /** Milliseconds of virtual time since the brick was first switched on; they go on while it is off. */
    val milliseconds: Long

    /**
     * Calls a ROM routine. An unknown address or a wrong code has no effect on the robot and is reported in the ROM log;
     * the program goes on.
     *
     * @param sourceLine the line of the program that makes the call, from 1; 0 if there is none (the firmware itself).
     */
    fun call(call: RomCall, sourceLine: Int)
}
