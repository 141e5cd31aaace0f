// A package of SCORM 1.2.
import { testScorm } from '../scorm.mjs';

testScorm('1.2', { score: 'cmi.core.score.raw', status: 'cmi.core.lesson_status', done: 'passed' });
