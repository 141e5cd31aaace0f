package robotran.legofirmware.instructions

import robotran.legofirmware.image.FirmwareTarget
import robotran.legofirmware.image.FirmwareTarget.RCX
import robotran.legofirmware.image.FirmwareTarget.RCX2
import robotran.legofirmware.instructions.OpcodeUse.ANYWHERE
import robotran.legofirmware.instructions.OpcodeUse.PROGRAM
import robotran.legofirmware.instructions.OpcodeUse.REQUEST
import robotran.legofirmware.instructions.OperandKind.BYTE
import robotran.legofirmware.instructions.OperandKind.BYTE_VALUE
import robotran.legofirmware.instructions.OperandKind.DIRECTION
import robotran.legofirmware.instructions.OperandKind.LONG_BRANCH
import robotran.legofirmware.instructions.OperandKind.LONG_JUMP
import robotran.legofirmware.instructions.OperandKind.LONG_LOOP
import robotran.legofirmware.instructions.OperandKind.MOTORS
import robotran.legofirmware.instructions.OperandKind.OUTPUT
import robotran.legofirmware.instructions.OperandKind.PLACE
import robotran.legofirmware.instructions.OperandKind.SENSOR
import robotran.legofirmware.instructions.OperandKind.SENSOR_MODE
import robotran.legofirmware.instructions.OperandKind.SENSOR_TYPE
import robotran.legofirmware.instructions.OperandKind.SHORT_BRANCH
import robotran.legofirmware.instructions.OperandKind.SHORT_JUMP
import robotran.legofirmware.instructions.OperandKind.TEST
import robotran.legofirmware.instructions.OperandKind.VALUE
import robotran.legofirmware.instructions.OperandKind.VARIABLE
import robotran.legofirmware.instructions.OperandKind.WORD
import robotran.legofirmware.instructions.OperandKind.ZERO

/**
 * The commands of LEGO's firmware. A real brick takes the number of operand bytes from the low three bits of the code: 6
 * means 0, 7 means 1, but [CHK] has 6 and [CHKL] has 7.
 *
 * Source: Proudfoot's opcode reference, and the sources of NQC for firmware 2.0.
 *
 * @property mnemonic as in listings; [STOP_ALL] and [STOP] share one, and so do those that delete.
 * @property operands in the order of their bytes.
 * @property firmware the first that knows it.
 */
enum class Opcode(
    val code: Int,
    val mnemonic: String,
    val operands: List<OperandKind> = emptyList(),
    val firmware: FirmwareTarget = RCX,
    val use: OpcodeUse = ANYWHERE,
) {
    /** A tone with the variable as its frequency, for a duration in 10 ms. */
    PLAYV(0x02, "playv", operands(VARIABLE, BYTE), firmware = RCX2),

    /** Fires the events of a mask. */
    EVENT(0x03, "event", operands(VALUE), firmware = RCX2),

    /** Calibrates an event: its upper limit, lower limit and hysteresis in per cent of the present reading. */
    CALE(0x04, "cale", operands(BYTE, BYTE, BYTE, BYTE), firmware = RCX2),

    /** Assigns a value to a variable, timer, limit and so on. */
    SET(0x05, "set", operands(PLACE, VALUE), firmware = RCX2),

    /** Forgets the definitions of all events. */
    DELE(0x06, "dele", firmware = RCX2),

    /** Does nothing. */
    PING(0x10, "ping"),

    /** Answers with a value. */
    POLL(0x12, "poll", operands(BYTE_VALUE), use = REQUEST),

    /** Sets the power of motors. */
    PWR(0x13, "pwr", operands(MOTORS, BYTE_VALUE)),

    /** Sets a variable. */
    SETV(0x14, "setv", operands(VARIABLE, VALUE)),

    /** Answers with the versions of ROM and firmware. */
    POLLP(0x15, "pollp", operands(BYTE, BYTE, BYTE, BYTE, BYTE), use = REQUEST),

    /** Calls a subroutine. */
    CALLS(0x17, "calls", operands(BYTE), use = PROGRAM),

    /** Answers with the addresses of all parts of the memory. */
    MEMMAP(0x20, "memmap", use = REQUEST),

    /** Switches motors on, off or to float. */
    OUT(0x21, "out", operands(OUTPUT)),

    /** Sets the watch: hours, minutes. */
    SETW(0x22, "setw", operands(BYTE, BYTE)),

    /** A tone: frequency, duration in 10 ms. */
    PLAYT(0x23, "playt", operands(WORD, BYTE)),

    /** Adds to a variable. */
    SUMV(0x24, "sumv", operands(VARIABLE, VALUE)),

    /** Begins the download of a task. */
    BEGIN_TASK(0x25, "_task", operands(BYTE, BYTE, BYTE, WORD), use = REQUEST),

    /** Jumps. */
    JMP(0x27, "jmp", operands(SHORT_JUMP), use = PROGRAM),

    /** Answers with the voltage of the battery. */
    POLLB(0x30, "pollb", use = REQUEST),

    /** Sets the range of infrared light: 0 short, 1 long. */
    TXS(0x31, "txs", operands(BYTE)),

    /** Sets the type of a sensor and its usual mode. */
    SENT(0x32, "sent", operands(SENSOR, SENSOR_TYPE)),

    /** Chooses what the display shows. */
    VIEW(0x33, "view", operands(VALUE)),

    /** Subtracts from a variable. */
    SUBV(0x34, "subv", operands(VARIABLE, VALUE)),

    /** Begins the download of a subroutine. */
    BEGIN_SUB(0x35, "_sub", operands(BYTE, BYTE, BYTE, WORD), use = REQUEST),

    /** Counts down the innermost loop, branches below 0. */
    LOOPC(0x37, "loopc", operands(SHORT_BRANCH), use = PROGRAM),

    /** Deletes all tasks. */
    DELETE_TASKS(0x40, "delt", use = REQUEST),

    /** Sets the mode of a sensor and clears its value. */
    SENM(0x42, "senm", operands(SENSOR, SENSOR_MODE)),

    /** Waits, in 10 ms. */
    WAIT(0x43, "wait", operands(VALUE), use = PROGRAM),

    /** Divides a variable. */
    DIVV(0x44, "divv", operands(VARIABLE, VALUE)),

    /** Stops all tasks. */
    STOP_ALL(0x50, "stop"),

    /** Plays one of the six system sounds. */
    PLAYS(0x51, "plays", operands(BYTE)),

    /** Makes a new datalog with room for that many entries; 0 removes it. */
    LOGZ(0x52, "logz", operands(WORD)),

    /** Multiplies a variable. */
    MULV(0x54, "mulv", operands(VARIABLE, VALUE)),

    /** Switches the brick off. */
    OFFP(0x60, "offp"),

    /** Deletes a task. */
    DELETE_TASK(0x61, "delt", operands(BYTE), use = REQUEST),

    /** Appends a value to the datalog. */
    LOG(0x62, "log", operands(BYTE_VALUE)),

    /** Answers with bytes of the memory. */
    POLLM(0x63, "pollm", operands(WORD, BYTE), firmware = RCX2, use = REQUEST),

    /** Sets a variable to the sign of a value. */
    SGNV(0x64, "sgnv", operands(VARIABLE, VALUE)),

    /** Enables or disables motors for all tasks. */
    GOUT(0x67, "gout", operands(OUTPUT), firmware = RCX2),

    /** Deletes all subroutines. */
    DELETE_SUBS(0x70, "dels", use = REQUEST),

    /** Starts a task at its beginning. */
    START(0x71, "start", operands(BYTE)),

    /** Jumps far. */
    JMPL(0x72, "jmpl", operands(LONG_JUMP), use = PROGRAM),

    /** Asks for resources, with a handler for losing them. */
    MONAL(0x73, "monal", operands(BYTE, LONG_JUMP), firmware = RCX2, use = PROGRAM),

    /** Sets a variable to the absolute value of a value. */
    ABSV(0x74, "absv", operands(VARIABLE, VALUE)),

    /** Sets what forwards means for all tasks. */
    GDIR(0x77, "gdir", operands(DIRECTION), firmware = RCX2),

    /** Empties the queue of sounds. */
    PLAYZ(0x80, "playz", firmware = RCX2),

    /** Stops a task. */
    STOP(0x81, "stop", operands(BYTE)),

    /** Begins a loop that counts down. */
    LOOPS(0x82, "loops", operands(BYTE_VALUE), use = PROGRAM),

    /** Bitwise and. */
    ANDV(0x84, "andv", operands(VARIABLE, VALUE)),

    /** Branches if a comparison is true. */
    CHK(0x85, "chk", operands(TEST, SHORT_BRANCH), use = PROGRAM),

    /** Forgets the received message. */
    MSGZ(0x90, "msgz"),

    /** Stops everything and selects a slot. */
    PRGM(0x91, "prgm", operands(BYTE)),

    /** A [LOOPC] that branches far. */
    LOOPCL(0x92, "loopcl", operands(LONG_LOOP), use = PROGRAM),

    /** Defines an event: its number, source, type. */
    SETE(0x93, "sete", operands(BYTE, BYTE, BYTE), firmware = RCX2),

    /** Bitwise or. */
    ORV(0x94, "orv", operands(VARIABLE, VALUE)),

    /** A [CHK] that branches far. */
    CHKL(0x95, "chkl", operands(TEST, LONG_BRANCH), use = PROGRAM),

    /** Increments a counter. */
    CNTI(0x97, "cnti", operands(BYTE), firmware = RCX2),

    /** Gives resources back. */
    MONAX(0xA0, "monax", firmware = RCX2, use = PROGRAM),

    /** Resets a timer. */
    TMRZ(0xA1, "tmrz", operands(BYTE)),

    /** Sets the maximum power of motors. */
    GPWR(0xA3, "gpwr", operands(MOTORS, BYTE_VALUE), firmware = RCX2),

    /** Sends entries of the datalog: first, count. */
    POLLD(0xA4, "polld", operands(WORD, WORD)),

    /** Starts a downloaded firmware. */
    BOOT(0xA5, "boot", operands(BYTE, BYTE, BYTE, BYTE, BYTE), use = REQUEST),

    /** Decrements a counter. */
    CNTD(0xA7, "cntd", operands(BYTE), firmware = RCX2),

    /** Ends monitoring events. */
    MONEX(0xB0, "monex", firmware = RCX2, use = PROGRAM),

    /** Sets after how many minutes the brick switches off; 0 is never. */
    TOUT(0xB1, "tout", operands(BYTE)),

    /** Sends a message to other bricks. */
    MSG(0xB2, "msg", operands(BYTE_VALUE), use = PROGRAM),

    /** Begins monitoring the events of a mask, with a handler. */
    MONE(0xB4, "mone", operands(VALUE, SHORT_JUMP), firmware = RCX2, use = PROGRAM),

    /** A [MONE] with a handler far away. */
    MONEL(0xB5, "monel", operands(VALUE, LONG_JUMP), firmware = RCX2, use = PROGRAM),

    /** Resets a counter. */
    CNTZ(0xB7, "cntz", operands(BYTE), firmware = RCX2),

    /** Deletes a subroutine. */
    DELETE_SUB(0xC1, "dels", operands(BYTE), use = REQUEST),

    /** Sends bytes of the serial buffer: first, count. */
    UART(0xC2, "uart", operands(BYTE, BYTE), firmware = RCX2),

    /** Switches all sounds off. */
    MUTE(0xD0, "mute", firmware = RCX2),

    /** Sets a sensor's counted value to 0. */
    SENZ(0xD1, "senz", operands(BYTE)),

    /** What the remote control sends. */
    REMOTE(0xD2, "remote", operands(WORD), firmware = RCX2),

    /** Sets the priority of the running task. */
    SETP(0xD7, "setp", operands(BYTE), firmware = RCX2, use = PROGRAM),

    /** Switches sounds on again. */
    SPEAK(0xE0, "speak", firmware = RCX2),

    /** Sets the direction of motors. */
    DIR(0xE1, "dir", operands(DIRECTION)),

    /** Chooses the value that the display shows for a program: decimals, value. */
    DISP(0xE5, "disp", operands(ZERO, BYTE, VALUE), firmware = RCX2),

    /** Decrements a variable, jumps below 0. */
    DECVJN(0xF2, "decvjn", operands(VARIABLE, SHORT_JUMP), firmware = RCX2, use = PROGRAM),

    /** A [DECVJN] that jumps far. */
    DECVJNL(0xF3, "decvjnl", operands(VARIABLE, LONG_JUMP), firmware = RCX2, use = PROGRAM),

    /** Returns from a subroutine. */
    RETS(0xF6, "rets", use = PROGRAM),

    /** Sets the received message. */
    MSGS(0xF7, "msgs", operands(BYTE)),
    ;

    /** Bytes of the whole instruction. */
    val size: Int = 1 + operands.sumOf { it.size }

    /** How this opcode holds an address; null if it has none. */
    val jump: JumpForm? = operands.firstNotNullOfOrNull { it.jump }

    /** The same command with a far target; null if there is none. */
    val longForm: Opcode? get() = LONG_FORMS[this]

    /** Whether a jump of this opcode at [address] can continue at [target]. Only for opcodes with a [jump]. */
    fun reaches(address: Int, target: Int): Boolean {
        val form = requireNotNull(jump) { "$this has no target." }
        return form.reaches(address + size - form.size, target)
    }

    companion object {
        /** The bit that a request over infrared light flips, so that the brick can tell it from a repeated one. */
        const val TOGGLE = 0x08

        private val LONG_FORMS =
            mapOf(JMP to JMPL, CHK to CHKL, LOOPC to LOOPCL, MONE to MONEL, DECVJN to DECVJNL)

        private val byCode: Map<Int, Opcode> = buildMap {
            Opcode.entries.filter { it.use != PROGRAM }.forEach { put(it.code xor TOGGLE, it) }
            Opcode.entries.forEach { put(it.code, it) }
        }

        /** The command with this [code], 0..255, possibly toggled; null if there is none. */
        fun of(code: Int): Opcode? = byCode[code]

        private val byMnemonic = entries.groupBy { it.mnemonic }

        /** The commands with this mnemonic, at most two. */
        fun named(mnemonic: String): List<Opcode> = byMnemonic[mnemonic].orEmpty()
    }
}

private fun operands(vararg kinds: OperandKind): List<OperandKind> = kinds.asList()
