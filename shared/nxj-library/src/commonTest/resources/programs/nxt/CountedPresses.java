import lejos.util.ButtonCounter;

/** LEFT and RIGHT count, with ENTER down; ENTER alone does nothing, and ESCAPE is the end. */
// press ENTER at 300
// press LEFT at 800
// press RIGHT at 1300
// press RIGHT at 1800
// press RIGHT at 2300
// press ENTER at 2800 for 600
// press RIGHT at 3050
// press LEFT at 3900 for 1300
// press ESCAPE at 5600
// screen How many?
// screen    4       2
public class CountedPresses {
    public static void main(String[] arguments) {
        ButtonCounter counter = new ButtonCounter();
        counter.count("How many?");
        System.out.println(counter.getLeftCount() + " " + counter.getRightCount()); // expect 4 2
    }
}
