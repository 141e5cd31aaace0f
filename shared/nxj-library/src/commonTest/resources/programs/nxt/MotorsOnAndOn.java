import lejos.nxt.Motor;

/** Motors that turn until they are told otherwise. */
public class MotorsOnAndOn {
    public static void main(String[] arguments) throws InterruptedException {
        Motor.B.setSpeed(200);
        Motor.B.forward();
        Thread.sleep(1000);
        int way = Motor.B.getTachoCount();
        System.out.println(way > 150 && way < 210); // expect true
        System.out.println(Motor.B.getRotationSpeed()); // expect 200
        Motor.B.setSpeed(400);
        Thread.sleep(500);
        System.out.println(Motor.B.getRotationSpeed() + " " + Motor.B.isMoving()); // expect 400 true
        Motor.B.backward();
        Thread.sleep(600);
        System.out.println(Motor.B.getRotationSpeed()); // expect -400
        Motor.B.stop();
        System.out.println(Motor.B.getRotationSpeed() + " " + Motor.B.isMoving()); // expect 0 false
        int held = Motor.B.getTachoCount();
        Thread.sleep(200);
        System.out.println(Math.abs(Motor.B.getTachoCount() - held) < 3); // expect true
        Motor.B.stop();
        Motor.B.forward();
        Thread.sleep(300);
        Motor.B.flt(true);
        Thread.sleep(300);
        System.out.println(Motor.B.isMoving()); // expect false
        Motor.B.forward();
        Thread.sleep(100);
        System.out.println(Motor.B.suspendRegulation() + " " + Motor.B.suspendRegulation()); // expect true false
        System.out.println(Motor.B.isMoving()); // expect false
    }
}
