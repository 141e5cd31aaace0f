package robotran.tinyvm.run

import robotran.rcxrom.program.Rom

/** The RCX around the machine. */
internal class RcxPeripherals(val rom: Rom) : Peripherals {
    lateinit var arrays: ArrayAddresses
        private set
    lateinit var region: HeapRegion
        private set
    lateinit var poller: Poller
        private set

    override val milliseconds: Long get() = rom.milliseconds

    override val wakesAt: Long? get() = if (poller.isActive) milliseconds + 1 else null

    override fun attach(machine: VirtualMachine) {
        arrays = ArrayAddresses(machine.heap, rom.memory, machine::charge)
        region = HeapRegion(machine.heap, rom.memory, arrays)
        poller = Poller(machine, rom)
    }

    override fun poll() = poller.poll()

    override fun roots(mark: (Int) -> Unit) = mark(poller.reference)

    override fun forget(isGone: (Int) -> Boolean) = arrays.forget(isGone)

    override fun delaysEnd(): Boolean = false
}

/** The RCX, for native methods that only its class library has. */
internal val VirtualMachine.rcx: RcxPeripherals get() = peripherals as RcxPeripherals
