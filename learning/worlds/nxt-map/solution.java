import lejos.nxt.LCD;
import lejos.nxt.Motor;
import lejos.nxt.SensorPort;
import lejos.nxt.UltrasonicSensor;
import lejos.robotics.navigation.DifferentialPilot;

/** Draws a map of what it hears from the right to the left, and drives where the way is longest. */
class Radar {
    public static void main(String[] args) throws InterruptedException {
        UltrasonicSensor sonar = new UltrasonicSensor(SensorPort.S4);
        DifferentialPilot pilot = new DifferentialPilot(5.6, 11.4, Motor.A, Motor.C);
        int longest = 0;
        int way = 0;
        int column = 0;
        for (int angle = -90; angle <= 90; angle += 15) {
            Motor.B.rotateTo(angle);
            Thread.sleep(150); // until it has heard
            int first = sonar.getDistance();
            Thread.sleep(100); // sometimes a sonar misses an echo
            int distance = Math.min(first, sonar.getDistance());
            for (int row = 0; row < distance / 20 && row < 8; row++) {
                LCD.drawString("#", column, 7 - row);
            }
            column++;
            if (distance > longest) {
                longest = distance;
                way = angle;
            }
        }
        Motor.B.rotateTo(0);
        pilot.rotate(way);
        pilot.travel(60);
    }
}
