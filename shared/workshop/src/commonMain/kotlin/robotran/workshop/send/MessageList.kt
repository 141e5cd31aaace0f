package robotran.workshop.send

import robotran.tower.ReceivedMessage
import robotran.workshop.platform.WallClock
import robotran.workshop.state.RobotMessage
import robotran.workshop.state.SendStep

/** The messages of a robot since now. */
internal class MessageList(private val clock: WallClock) {
    private val start = clock.now
    private var count = 0

    var messages: List<RobotMessage> = emptyList()
        private set

    /** Adds a message that has just come. */
    fun add(received: ReceivedMessage): List<RobotMessage> {
        val message = RobotMessage(count++, clock.now - start, received)
        messages = (messages + message).takeLast(SendStep.MAX_MESSAGES)
        return messages
    }
}
