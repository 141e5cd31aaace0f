package lejos.robotics;

/** A motor that is not regulated, turned round. */
class ReversedEncoderMotor implements EncoderMotor {
    final EncoderMotor motor;

    ReversedEncoderMotor(EncoderMotor motor) {
        this.motor = motor;
    }

    public void setPower(int power) {
        motor.setPower(power);
    }

    public int getPower() {
        return motor.getPower();
    }

    public void forward() {
        motor.backward();
    }

    public void backward() {
        motor.forward();
    }

    public void stop() {
        motor.stop();
    }

    public void flt() {
        motor.flt();
    }

    public boolean isMoving() {
        return motor.isMoving();
    }

    public int getTachoCount() {
        return -motor.getTachoCount();
    }

    public void resetTachoCount() {
        motor.resetTachoCount();
    }
}
