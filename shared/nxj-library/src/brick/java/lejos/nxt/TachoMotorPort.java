package lejos.nxt;

import lejos.robotics.Encoder;

/** A port for a motor that counts degrees. */
public interface TachoMotorPort extends BasicMotorPort, Encoder {
}
