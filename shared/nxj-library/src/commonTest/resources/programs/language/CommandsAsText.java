import java.util.ArrayList;
import java.util.List;
import java.util.StringTokenizer;

public class CommandsAsText {
    static abstract class Command {
        abstract void drive(Turtle turtle);
    }

    static class Forward extends Command {
        private final double distance;

        Forward(double distance) {
            this.distance = distance;
        }

        @Override
        void drive(Turtle turtle) {
            turtle.x += distance * turtle.cosine();
            turtle.y += distance * turtle.sine();
        }
    }

    static class Left extends Command {
        private final int quarters;

        Left(int quarters) {
            this.quarters = quarters;
        }

        @Override
        void drive(Turtle turtle) {
            turtle.quarter = (turtle.quarter + quarters) & 3;
        }
    }

    static class Repeat extends Command {
        final List<Command> body = new ArrayList<Command>();
        private final int times;

        Repeat(int times) {
            this.times = times;
        }

        @Override
        void drive(Turtle turtle) {
            for (int i = 0; i < times; i++) {
                for (Command command : body) command.drive(turtle);
            }
        }
    }

    static class Turtle {
        double x;
        double y;
        int quarter;

        int cosine() {
            return quarter == 0 ? 1 : quarter == 2 ? -1 : 0;
        }

        int sine() {
            return quarter == 1 ? 1 : quarter == 3 ? -1 : 0;
        }

        @Override
        public String toString() {
            return "(" + x + ", " + y + ") " + 90 * quarter;
        }
    }

    static List<Command> read(StringTokenizer words) {
        List<Command> commands = new ArrayList<Command>();
        while (words.hasMoreTokens()) {
            String word = words.nextToken();
            if (word.equals("end")) break;
            if (word.equals("forward")) {
                commands.add(new Forward(Double.parseDouble(words.nextToken())));
            } else if (word.equals("left")) {
                commands.add(new Left(Integer.parseInt(words.nextToken()) / 90));
            } else if (word.equals("repeat")) {
                Repeat repeat = new Repeat(Integer.parseInt(words.nextToken()));
                repeat.body.addAll(read(words));
                commands.add(repeat);
            } else {
                throw new IllegalStateException("What is " + word + "?");
            }
        }
        return commands;
    }

    public static void main(String[] arguments) {
        String[] programs = {
            "forward 2.5 left 90 forward 4",
            "repeat 4 forward 10 left 90 end",
            "repeat 3 repeat 2 forward 1.5 left 90 end left 180 end forward 1",
            "backward 3",
            "forward x",
        };
        for (String program : programs) {
            Turtle turtle = new Turtle();
            try {
                for (Command command : read(new StringTokenizer(program, " "))) command.drive(turtle);
                System.out.println(turtle);
            } catch (NumberFormatException wrong) {
                System.out.println("no number");
            } catch (IllegalStateException wrong) {
                System.out.println(wrong.getMessage());
            }
        }
        // expect (2.5, 4.0) 90
        // expect (0.0, 0.0) 0
        // expect (5.5, 4.5) 0
        // expect What is backward?
        // expect no number
    }
}
