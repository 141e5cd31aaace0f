package lejos.robotics.localization;

import lejos.robotics.navigation.Pose;

/** Knows where the robot is. */
public interface PoseProvider {
    /** Gives where the robot is and where it looks. */
    Pose getPose();

    /** Sets where the robot is and where it looks. */
    void setPose(Pose aPose);
}
