package lejos.robotics.subsumption;

/** One thing a robot can do, and when it wants to do it; an Arbitrator chooses. */
public interface Behavior {
    /** Says whether this behaviour wants the robot now. */
    boolean takeControl();

    /** Does what the behaviour is for; it ends soon after suppress was called. */
    void action();

    /** Is called when a more important behaviour wants the robot: let action end. */
    void suppress();
}
