package robotran.editing

/** What the ready robots are called, by their keys. */
val READY_ROBOT_WORDS: Map<String, Words> = mapOf(
    "rcx-penbot" to RobotTexts::readyRcxPenbot,
    "nxt-penbot" to RobotTexts::readyNxtPenbot,
    "line-follower" to RobotTexts::readyLineFollower,
    "sumo" to RobotTexts::readySumo,
    "both-sides" to RobotTexts::readyBothSides,
    "spike-penbot" to RobotTexts::readySpikePenbot,
    "spike-scout" to RobotTexts::readySpikeScout,
    "essential-rover" to RobotTexts::readyEssentialRover,
    "technic-penbot" to RobotTexts::readyTechnicPenbot,
    "ev3-penbot" to RobotTexts::readyEv3Penbot,
    "nxt-pybricks-penbot" to RobotTexts::readyNxtPybricksPenbot,
)
