package robotran.legofirmware.device

/** What a brick keeps for all of its programs, but for their variables. */
internal class Devices(val calls: RomCalls) {
    val outputs = Outputs(calls)
    val inputs = Inputs(calls)
    val sounds = Sounds(calls)
    val clocks = Clocks { calls.rom.milliseconds }
    val datalog = Datalog()
    val infrared = Infrared(calls)
    val power = Power(calls)
    val random = RandomNumbers()
    val viewing = Viewing()

    /** Index of the selected slot. */
    var slot = 0
}
