package lejos.robotics;

/** Counts the degrees that a motor turns. */
public interface Encoder {
    /** Gives how many degrees the motor has turned since it was counted from 0. */
    int getTachoCount();

    /** Counts from 0. */
    void resetTachoCount();
}
