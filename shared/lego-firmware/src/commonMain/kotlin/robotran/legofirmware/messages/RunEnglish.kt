package robotran.legofirmware.messages

import robotran.language.quoted

internal object RunEnglish : RunMessages {
    override fun nestedCall() =
        "This subroutine was called by another subroutine. A brick remembers only one way back, " +
            "so all tasks stop when the first subroutine ends."

    override fun invalidOpcode(byte: Int, address: Int) =
        "There is no command with the number $byte (address $address). This task stops here."

    override fun newerCommand(command: String) = "Firmware 1.0 has no command ${quoted(command)}. This task stops here."

    override fun requestOnly(command: String) =
        "${quoted(command)} works only over infrared light. Here it does nothing."

    override fun divisionByZero() = "A division by 0 changes nothing: the variable keeps its value."

    override fun datalogFull(entries: Int) = "The datalog is full: $entries entries. Further values are lost."

    override fun noDatalog() = "There is no datalog yet, so this value is lost. Create one first."

    override fun noTask(number: Int) = "There is no task $number, so nothing starts."

    override fun noSub(number: Int) = "There is no subroutine $number, so nothing happens."

    override fun noVariable(number: Int) = "There is no variable $number. Its value is 0."

    override fun noSource(source: Int) = "An RCX has no source $source. Its value is 0."

    override fun notWritable(source: Int) = "Source $source can only be read. Nothing changes."

    override fun wrongPower(power: Int) = "The power $power is ignored. It must be from 0 to 7."

    override fun noPort(number: Int) = "There is no port, timer, counter or event number $number. Nothing happens."

    override fun tooManyLoops() = "At most four counted loops fit into each other. The count of the fourth is lost."

    override fun noLoop() = "There is no counted loop here that could be over."

    override fun jumpOut() = "This jump leads out of the task or subroutine, which ends."

    override fun task(number: Int) = "task $number"

    override fun sub(number: Int) = "sub $number"

    override fun localVariables() = "own variables"

    override fun motorsStayOn() = "The program is over, but its motors stay on: LEGO's firmware does not stop them. " +
        "A program that is to stop ends with the motors off."

    override fun emptySlot(slot: Int) = "There is no program in slot $slot. Choose another one with the Prgm button."
}
