package robotran.legofirmware.messages

/** What a brick does silently while a program runs, as whole sentences. */
interface RunMessages {
    /** A subroutine called another one, so its own return address is lost. */
    fun nestedCall(): String

    fun invalidOpcode(byte: Int, address: Int): String

    fun newerCommand(command: String): String

    fun requestOnly(command: String): String

    fun divisionByZero(): String

    fun datalogFull(entries: Int): String

    fun noDatalog(): String

    fun noTask(number: Int): String

    fun noSub(number: Int): String

    fun noVariable(number: Int): String

    fun noSource(source: Int): String

    fun notWritable(source: Int): String

    fun wrongPower(power: Int): String

    /** A sensor, motor, timer, counter or event that is not there. */
    fun noPort(number: Int): String

    fun tooManyLoops(): String

    fun noLoop(): String

    fun jumpOut(): String

    /** The name of a task without a name. */
    fun task(number: Int): String

    /** The name of a subroutine without a name. */
    fun sub(number: Int): String

    /** The heading of the variables of a task. */
    fun localVariables(): String

    /** The program has ended, but motors are on. */
    fun motorsStayOn(): String

    /** Why Run starts nothing. */
    fun emptySlot(slot: Int): String
}
