// only here
import lejos.util.PIDController;

/** The sum and the change of the error are those of milliseconds. */
public class GainsInMilliseconds {
    public static void main(String[] arguments) {
        PIDController controller = new PIDController(100, 20);
        controller.setPIDParam(PIDController.PID_KI, 0.02f);
        controller.setPIDParam(PIDController.PID_KD, 4);
        System.out.println(controller.doPID(90)); // expect 0
        System.out.println(controller.doPID(90)); // expect 900
        System.out.println(controller.doPID(92)); // expect 10
        System.out.println(controller.doPID(95)); // expect 9
        System.out.println(controller.doPID(104)); // expect -2
        controller.freezeIntegral(true);
        System.out.println(controller.doPID(104) + " " + controller.isIntegralFrozen()); // expect 0 true
        System.out.println(Math.round(controller.getPIDParam(PIDController.PID_I) * 10)); // expect 36
        System.out.println(controller.getPIDParam(PIDController.PID_PV)); // expect 104.0
        controller.setPIDParam(PIDController.PID_KP, 2);
        System.out.println(controller.getPIDParam(PIDController.PID_I)); // expect 0.0
        controller.setPIDParam(PIDController.PID_PV, 7);
        System.out.println(controller.getPIDParam(PIDController.PID_PV)); // expect 104.0
        controller.setPIDParam(PIDController.PID_I_LIMITHIGH, 5);
        controller.freezeIntegral(false);
        System.out.println(controller.doPID(90)); // expect 26
        System.out.println(controller.doPID(90)); // expect 25
        controller.setPIDParam(PIDController.PID_RAMP_POWER, 2);
        controller.setPIDParam(PIDController.PID_RAMP_THRESHOLD, 100);
        System.out.println(controller.doPID(90)); // expect 5
        controller.setDelay(0);
        System.out.println(controller.getDelay()); // expect 0
    }
}
