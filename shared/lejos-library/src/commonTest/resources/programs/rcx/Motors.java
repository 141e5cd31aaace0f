import josx.platform.rcx.LCD;
import josx.platform.rcx.Motor;

public class Motors {
    static void show(Motor motor) {
        int state = 0;
        if (motor.isForward()) state += 1;
        if (motor.isBackward()) state += 10;
        if (motor.isMoving()) state += 100;
        if (motor.isFloating()) state += 1000;
        if (motor.isStopped()) state += 2000;
        LCD.setNumber(0x301f, state, 0x3002); // rom: 0x1ff2 0x301f 1000 0x3002 | 0x1ff2 0x301f 101 0x3002 | 0x1ff2 0x301f 110 0x3002 | 0x1ff2 0x301f 2000 0x3002
    }

    public static void main(String[] arguments) {
        show(Motor.B);
        Motor.B.reverseDirection();
        Motor.B.setPower(5); // rom: 0x1a4e 0x2001 4 5
        Motor.B.forward(); // rom: 0x1a4e 0x2001 1 5
        show(Motor.B);
        Motor.B.reverseDirection(); // rom: 0x1a4e 0x2001 2 5
        show(Motor.B);
        Motor.B.reverseDirection(); // rom: 0x1a4e 0x2001 1 5
        Motor.B.backward(); // rom: 0x1a4e 0x2001 2 5
        Motor.B.setPower(9); // rom: 0x1a4e 0x2001 2 9
        Motor.B.stop(); // rom: 0x1a4e 0x2001 3 7
        show(Motor.B);
        Motor.B.flt(); // rom: 0x1a4e 0x2001 4 9
        Motor.controlMotor('C', 1, 2); // rom: 0x1a4e 0x2002 1 2
        if (Motor.A.getPower() == 3) Motor.A.setPower(Motor.B.getPower()); // rom: 0x1a4e 0x2000 4 9
        if (Motor.A.getId() == 'A' && Motor.C.getId() == 'C') Motor.C.stop(); // rom: 0x1a4e 0x2002 3 7
    }
}
