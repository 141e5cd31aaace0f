package lejos.robotics;

/** A motor without regulation that counts degrees. */
public interface EncoderMotor extends DCMotor, Encoder {
}
