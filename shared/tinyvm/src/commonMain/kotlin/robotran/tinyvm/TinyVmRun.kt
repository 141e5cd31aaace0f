package robotran.tinyvm

import robotran.rcxrom.program.Rom
import robotran.tinyvm.config.BrickRoom
import robotran.tinyvm.config.LejosVersion
import robotran.tinyvm.config.MachineModel
import robotran.tinyvm.config.TinyVmMode
import robotran.tinyvm.config.TinyVmSpeed
import robotran.tinyvm.link.LinkedProgram
import robotran.tinyvm.messages.TinyVmRunMessages
import robotran.tinyvm.natives.NativeMethods
import robotran.tinyvm.run.RcxPeripherals
import robotran.tinyvm.run.VirtualMachine

/** One run of a program linked for an RCX. */
internal class TinyVmRun(
    program: LinkedProgram,
    rom: Rom,
    mode: TinyVmMode,
    messages: TinyVmRunMessages,
    speed: TinyVmSpeed,
    version: LejosVersion,
    room: BrickRoom = BrickRoom.of(version),
) : ThreadedRun(
        VirtualMachine(
            program,
            RcxPeripherals(rom),
            MachineModel.of(mode),
            messages,
            room.objectBytes(program.bytes),
            room.bytes,
        ),
        messages,
        speed.bytecodesPerStep,
        NativeMethods::find,
    )
