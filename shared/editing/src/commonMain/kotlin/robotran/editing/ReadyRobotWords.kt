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
    "cutebot" to RobotTexts::readyCutebot,
    "cutebot-pro" to RobotTexts::readyCutebotPro,
    "maqueen" to RobotTexts::readyMaqueen,
    "maqueen-plus" to RobotTexts::readyMaqueenPlus,
    "tiny-bit" to RobotTexts::readyTinyBit,
    "kitronik-penbot" to RobotTexts::readyKitronikPenbot,
    "plain-buggy" to RobotTexts::readyPlainBuggy,
    "cutebot-v1" to RobotTexts::readyCutebotV1,
)
