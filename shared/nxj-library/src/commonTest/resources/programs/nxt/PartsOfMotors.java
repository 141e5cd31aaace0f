import lejos.nxt.Button;
import lejos.nxt.MotorPort;
import lejos.nxt.NXTMotor;
import lejos.nxt.NXTRegulatedMotor;
import lejos.nxt.TachoMotorPort;

// What classes of a program see of motors that they extend, and the array of all buttons.
public class PartsOfMotors {
    static class Wheel extends NXTRegulatedMotor {
        Wheel(TachoMotorPort port) {
            super(port);
        }

        String parts() {
            return speed + " " + acceleration + " " + (listener == null) + " " + (tachoPort == MotorPort.B) + " "
                + NO_LIMIT;
        }
    }

    static class Fan extends NXTMotor {
        Fan() {
            super(MotorPort.C);
        }

        boolean isUnknown() {
            return mode == INVALID_MODE;
        }
    }

    @SuppressWarnings("deprecation")
    public static void main(String[] arguments) {
        Wheel wheel = new Wheel(MotorPort.B);
        wheel.setSpeed(-100);
        wheel.setAcceleration(2000);
        System.out.println(wheel.parts()); // expect 100.0 2000 true true 2147483647
        wheel.rotate(90);
        System.out.println(wheel.getLimitAngle()); // expect 90
        System.out.println(new Fan().isUnknown()); // expect false
        String names = "";
        for (Button button : Button.BUTTONS) names += button.getId() + " ";
        System.out.println(names + (Button.BUTTONS[3] == Button.ESCAPE)); // expect 1 2 4 8 true
    }
}
